#pragma once

#include "checks/sampler/sampler.h"

namespace plumb::checks {

/// Adds the claim that the values of the lines have the trial's mean.
void add_mean(Catalogue& catalogue, const SamplerTrial& trial, std::uint64_t seed);

/// Adds the claims that samples follow the density that their own lines state, x,pdf or x,y,pdf, and that it integrates
/// to 1: the mean of 1/pdf over the samples in a cell is the cell's size.
void add_own_density(Catalogue& catalogue, const SamplerTrial& trial, std::uint64_t seed);

}  // namespace plumb::checks
