#pragma once

#include <cstdint>
#include <vector>

#include "core/point.h"

namespace plumb {

/// The digits of i in this base, mirrored at the point: 6 = 110 in base 2 gives 0.011 = 3/8. Correctly rounded, in
/// [0,1), for base ≥ 2 and i < 2^32.
double radical_inverse(std::uint32_t base, std::uint32_t i);

/// The first n points of the sequence whose axes are radical inverses in the bases 2 and 3; in 1D van der Corput's.
/// The first point is the origin. Source: [van der Corput 1935; Halton 1960].
std::vector<Point<1>> halton_1d(std::uint64_t n);
std::vector<Point<2>> halton_2d(std::uint64_t n);

/// i/n on the first axis, radical inverses in base 2 on the second; in 1D the regular grid. [Hammersley 1960].
std::vector<Point<1>> hammersley_1d(std::uint64_t n);
std::vector<Point<2>> hammersley_2d(std::uint64_t n);

}  // namespace plumb
