#pragma once

#include <vector>

#include "verification/pictures/flip_colour.h"
#include "verification/pictures/image_errors.h"
#include "verification/pictures/picture.h"

namespace plumb {

// FLIP: how much a person sees who looks at two pictures in turn [Andersson et al. 2020; Andersson et al. 2021].

namespace flip {

/// A 4K screen of 0.7 m at a distance of 0.7 m: 3840 · π/180.
inline constexpr double pixels_per_degree = 67.0206432765823;

/// A picture as a screen is given it.
struct Shown {
    int width = 0, height = 0;
    std::vector<Triple> rgb;  ///< linear sRGB in [0, 1]
};

/// FLIP of each pixel, in [0, 1]: the colours' difference as far as the eye resolves it, to the power of 1 less the
/// difference of edges and points.
std::vector<double> errors_of(const Shown& reference, const Shown& test);

/// Exposures in stops for HDR-FLIP: from the one that shows the reference's brightest pixel at 0.85 of white, by steps
/// of a stop or less, to the one that does that with its median: two at least.
std::vector<double> exposures_of(const std::vector<Triple>& reference);

/// The curve of ACES as HDR-FLIP has it [Narkowicz 2016], of a number at exposure 0, in [0, 1].
double tone_mapped(double x);

}  // namespace flip

/// FLIP and HDR-FLIP of a against b, means over all pixels that are finite in both. FLIP takes both as linear sRGB, cut
/// off at 1; HDR-FLIP is the largest error of each pixel over exposures. They are numbers of two images as they are,
/// noise and all: their intervals are NaN. Where half of b is black its median is that of what is not.
std::vector<ErrorMeasure> flip_errors_of(const Picture& a, const Picture& b);

}  // namespace plumb
