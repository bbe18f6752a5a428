#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/images/image.h"

namespace plumb {

// Channels have their layer's name in front, "ViewLayer.Combined.R"; those without are of the picture itself. Colours
// are the channels R, G and B, or X, Y and Z, or Y.

/// The names of the colours that the image has: R, G and B before X, Y and Z before Y; empty where it has none. The Y
/// of C, M, Y and K is yellow.
std::vector<std::string> colours_of(const Image& image);

/// The layers that have colours, by name.
std::vector<std::string> coloured_layers(const Image& image);

/// The picture that an image shows: the layer of this name, or without one the image itself where it has colours, else
/// its only layer that has. Throws Error naming the file, its channels and its layers where there is none, or several.
Image picture_layer(Image image, const std::filesystem::path& file, const std::string& layer = "");

}  // namespace plumb
