#pragma once

#include "checks/sampler/sampler.h"

namespace plumb::checks {

/// Adds the claim that samples come from this density; where lines have one number more, it must be the density there.
void add_density(Catalogue& catalogue, const SamplerTrial& trial, CellDensity density, std::uint64_t seed,
                 double alpha);

}  // namespace plumb::checks
