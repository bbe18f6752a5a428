#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/error.h"
#include "scenes/description/models.h"

namespace plumb {

// Pixel filters as densities of the offset from a pixel's centre, in pixels: of integral 1 along each axis, and
// sampled. A pixel is the plain mean of its own samples, drawn by its filter [Ernst, Stamminger & Greiner 2006]: no
// weights, hence no division by summed weights, which is a ratio and biased. One axis, as in
// estimators/densities/density.h:
//   sample(u), pdf(x), invert(x), radius().
// And what scenes/description/models.h asks for.

/// The radius of a filter in a scene's file; throws Error unless it is above 0.
inline double checked_radius(const description::Properties& properties, double radius) {
    if (!(radius > 0))
        throw properties.place().error(fmt::format("a filter of radius {}; above 0 is accepted", radius));
    return radius;
}

/// The value, a size of the kind `what`; throws Error unless it is positive and finite.
inline double positive_size(double value, const char* what) {
    if (!(value > 0 && std::isfinite(value)))
        throw Error(fmt::format("{} is {}: it must be positive and finite", what, value));
    return value;
}

}  // namespace plumb
