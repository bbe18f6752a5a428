#pragma once

#include <cstdint>
#include <vector>

#include "core/point.h"
#include "core/random.h"

namespace plumb {

/// n independent uniform points: the plain Monte Carlo set.
template <int D>
std::vector<Point<D>> independent_points(std::uint64_t n, RandomStream& random);

/// One uniform point in each of n equal intervals, in order [Haber 1966].
std::vector<Point<1>> stratified_1d(std::uint64_t n, RandomStream& random);

/// One uniform point in each of the n cells of grid_of(n), row by row ("jittered"). Source: [Haber 1966].
std::vector<Point<2>> stratified_2d(std::uint64_t n, RandomStream& random);

}  // namespace plumb
