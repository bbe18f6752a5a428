#pragma once

#include <array>
#include <cmath>

#include "scenes/description/models.h"

namespace plumb::description {

/// Squares of side 1/2, with color0 around (1/4, 1/4) and (3/4, 3/4).
struct Checkerboard {
    Spectrum color0 = Spectrum::grey(0.4), color1 = Spectrum::grey(0.2);

    static constexpr std::array plugins{Plugin{"checkerboard", "squares of two colours"}};
    static Checkerboard load(Properties& properties) {
        const Checkerboard otherwise;
        return {properties.constant_reflectance("color0", otherwise.color0),
                properties.constant_reflectance("color1", otherwise.color1)};
    }
    [[nodiscard]] Spectrum at(double u, double v) const {
        const bool right = u - std::floor(u) >= 0.5, low = v - std::floor(v) >= 0.5;
        return right == low ? color0 : color1;
    }
};

}  // namespace plumb::description
