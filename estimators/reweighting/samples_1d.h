#pragma once

#include <cstdint>
#include <vector>

#include "core/random.h"

namespace plumb {

/// n independent uniform samples of [0,1).
std::vector<double> independent_samples_1d(std::uint64_t n, RandomStream& random);

/// One uniform sample in each of n equal strata, in order.
std::vector<double> jittered_samples_1d(std::uint64_t n, RandomStream& random);

}  // namespace plumb
