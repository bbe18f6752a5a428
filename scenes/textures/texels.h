#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/spectrum.h"

namespace plumb {

/// Linear RGB texels, row by row from the top. A grey texel is three equal numbers; alpha is dropped.
struct Texels {
    int width = 0, height = 0;
    std::vector<float> rgb;  ///< 3·width·height

    [[nodiscard]] Spectrum texel(int x, int y) const {
        const float* p = rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                           static_cast<std::size_t>(x));
        return Spectrum::rgb(p[0], p[1], p[2]);
    }
};

/// Reads any file that OpenImageIO decodes. Integer texels are taken as sRGB and made linear, unless raw; floats are
/// taken as they are. Throws Error naming the file for what it cannot decode, and for texels that are NaN, infinite or
/// negative.
Texels read_texels(const std::filesystem::path& file, bool raw = false);

}  // namespace plumb
