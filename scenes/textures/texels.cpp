#include "scenes/textures/texels.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/image.h"
#include "core/srgb.h"

namespace plumb {

Texels read_texels(const std::filesystem::path& file, bool raw) {
    const Image image = read_image(file);
    require_finite(image, file);
    const std::size_t channels = image.channels.size();
    Texels texels{image.width, image.height, {}};
    texels.rgb.reserve(image.values.size() / channels * 3);
    for (std::size_t at = 0; at < image.values.size(); at += channels) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = image.values[at + (channels >= 3 ? c : 0)];
            if (value < 0) {
                throw Error(
                    fmt::format("{}: texel {} is {}; accepted are values from 0", file.string(), at / channels, value));
            }
            texels.rgb.push_back(image.of_integers && !raw ? linear_from_srgb(value) : value);
        }
    }
    return texels;
}

}  // namespace plumb
