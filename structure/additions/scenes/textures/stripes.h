#pragma once

#include <array>
#include <cmath>

#include "scenes/description/models.h"

namespace plumb::description {

/// Two stripes along v a period of u: color0 from 0 to 1/2.
struct Stripes {
    Spectrum color0 = Spectrum::grey(0.4), color1 = Spectrum::grey(0.2);

    static constexpr std::array plugins{Plugin{"stripes", "stripes of two colours"}};
    static Stripes load(Properties& properties) {
        const Stripes otherwise;
        return {properties.constant_reflectance("color0", otherwise.color0),
                properties.constant_reflectance("color1", otherwise.color1)};
    }
    [[nodiscard]] Spectrum at(double u, double) const { return u - std::floor(u) < 0.5 ? color0 : color1; }
};

}  // namespace plumb::description
