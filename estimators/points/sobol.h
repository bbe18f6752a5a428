#pragma once

#include <cstdint>
#include <vector>

#include "core/point.h"
#include "core/random.h"
#include "estimators/points/digital_net.h"

namespace plumb {

/// The first n points of Sobol's sequence [Sobol' 1967], direction numbers of [Joe & Kuo 2008] through Boost.Random, in
/// Gray-code order. The origin, which Boost leaves out, is there: without it the first 2^k points are no net.
/// n < 2^32.
template <int D>
std::vector<BinaryPoint<D>> sobol_digits(std::uint64_t n);

/// Sobol's sequence as it is, and with nested uniform scrambling.
std::vector<Point<1>> sobol_1d(std::uint64_t n);
std::vector<Point<2>> sobol_2d(std::uint64_t n);
std::vector<Point<1>> owen_sobol_1d(std::uint64_t n, RandomStream& random);
std::vector<Point<2>> owen_sobol_2d(std::uint64_t n, RandomStream& random);

}  // namespace plumb
