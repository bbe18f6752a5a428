#pragma once

#include <map>
#include <string>
#include <vector>

namespace plumb {

/// An image with named channels, pixel by pixel, rows from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<float> values;
    std::map<std::string, std::string> metadata = {};
};

/// Writes an image in the format of the file's extension, written aside and then renamed. EXR and TIFF keep floats and
/// names. Throws Error naming the file.
void write_image(const std::string& path, const Image& image);

/// Reads any format that OpenImageIO reads, as floats, integers scaled to [0, 1]. Throws Error naming the file.
Image read_image(const std::string& path);

}  // namespace plumb
