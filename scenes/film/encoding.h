#pragma once

#include <filesystem>

#include "core/images/image.h"

namespace plumb {

/// The layers and channels that a file of this name can hold of an image: formats with floats and names (EXR, TIFF) get
/// every layer, the others the first three channels, those with floats (HDR, PFM) linear and the rest in sRGB, clamped
/// to [0, 1].
Image encoded_for(const std::filesystem::path& file, const Image& image);

}  // namespace plumb
