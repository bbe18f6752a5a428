#pragma once

#include <cstdint>

#include "estimators/estimator.h"

namespace plumb {

/// One independent run with n samples.
using IndependentRun = std::function<Estimate(std::uint64_t n, RandomStream&)>;

/// The mean of `batches` independent runs that share n samples (sizes differ by at most one): its expectation is that
/// of a run, and the batches' spread gives the standard error that one run cannot know (infinite for one batch). Throws
/// Error unless 1 ≤ batches ≤ n.
Estimate mean_of_batches(const IndependentRun& run, std::uint64_t n, std::uint64_t batches, RandomStream& random);

}  // namespace plumb
