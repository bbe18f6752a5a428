#pragma once

#include "core/point.h"

namespace plumb {

/// φ(u) = 1 − |2u − 1|: covers [0,1] twice with Jacobian 2 on each half, so ∫ f∘φ = ∫ f, and φ(0) = φ(1): f∘φ is
/// continuous on the torus when f is continuous. Exact for every double in [0,1].
inline double tent(double u) {
    return u < 0.5 ? 2 * u : 2 * (1 - u);
}

/// φ along each axis.
template <std::size_t D>
std::array<double, D> tent(std::array<double, D> u) {
    for (double& axis : u) axis = tent(axis);
    return u;
}

}  // namespace plumb
