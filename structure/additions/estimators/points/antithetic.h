#pragma once

#include <cstdint>
#include <vector>

#include "core/point.h"
#include "core/random.h"

namespace plumb {

/// Independent uniform points in pairs that are mirror images at the square's centre; of an odd n the last one is
/// alone.
std::vector<Point<2>> antithetic_2d(std::uint64_t n, RandomStream& random);

}  // namespace plumb
