#pragma once

#include <cstdint>
#include <vector>

#include "core/point.h"
#include "core/random.h"
#include "estimators/points/digital_net.h"

namespace plumb {

/// The first n points of the (0,2)-sequence in base 2 of [Kollig & Keller 2002]: van der Corput's sequence and Sobol's
/// second axis, by index. Every aligned run of 2^k points holds one point in each elementary interval of area 2^-k.
/// The runs are those of sobol_2d in another order: the two sequences agree as sets where n is a power of two. n <
/// 2^32.
std::vector<BinaryPoint<2>> zero_two_digits(std::uint64_t n);

/// The sequence as it is, with random digit scrambling (what renderers use), and with nested uniform scrambling.
std::vector<Point<2>> zero_two(std::uint64_t n);
std::vector<Point<2>> xor_zero_two(std::uint64_t n, RandomStream& random);
std::vector<Point<2>> owen_zero_two(std::uint64_t n, RandomStream& random);

}  // namespace plumb
