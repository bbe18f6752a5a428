#pragma once

#include <cstdint>
#include <vector>

#include "core/point.h"
#include "core/random.h"

namespace plumb {

/// One point in each of n columns and one in each of n rows: columns in order, rows by a random permutation, jittered
/// in both. n < 2^32. Source: [McKay, Beckman & Conover 1979].
std::vector<Point<2>> latin_hypercube_2d(std::uint64_t n, RandomStream& random);

}  // namespace plumb
