#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plumb {

/// A decoded image: rows from the top, each of `width` pixels, each of one number a channel. Numbers are those of the
/// file, integers of b bits divided by 2^b − 1; no colour transform is applied.
struct Image {
    int width = 0, height = 0;
    std::vector<std::string> channels;  ///< names, e.g. R, G, B, A
    std::vector<float> values;

    [[nodiscard]] float at(int x, int y, std::size_t channel) const {
        return values[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                          channels.size() +
                      channel];
    }
};

/// Decodes any format that OpenImageIO reads. Throws Error naming the file when there is none, when it is not an image,
/// truncated, deep, of three dimensions or larger than 2^30 numbers, and naming the pixel whose value is not finite.
Image read_image(const std::filesystem::path& file);

}  // namespace plumb
