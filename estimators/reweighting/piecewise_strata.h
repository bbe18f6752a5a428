#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analytic/step_density.h"
#include "estimators/estimator.h"

namespace plumb {

/// The number of n samples that each piece gets: about n times its mass, by largest remainders, at least one each (so
/// at least `pieces` in all). It is a function of n alone: counts drawn at random would leave pieces empty and lose
/// their integral.
std::vector<std::uint64_t> stratum_counts(const StepDensity& density, std::uint64_t n);

/// Samples of a piecewise-constant density, each piece reweighted by itself as [0,1] is by |V|/g with its own count
/// [thesis, section 4.4.4]. Unbiased for any counts ≥ 1, one per piece; throws Error for a count of 0 or too few
/// counts.
Estimate piecewise_strata_estimate(const Function<1>& f, const StepDensity& density,
                                   std::span<const std::uint64_t> counts, RandomStream& random);

}  // namespace plumb
