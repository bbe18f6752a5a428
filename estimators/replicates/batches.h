#pragma once

#include <cstdint>

#include "estimators/estimator.h"

namespace plumb {

/// One independent run with n samples.
using IndependentRun = std::function<Estimate(std::uint64_t n, RandomStream&)>;

/// The mean of `batches` independent runs that share n samples (sizes differ by at most one): its expectation is that
/// of a run, and the batches' spread gives the standard error that one run cannot know (MeanOfRuns: infinite for one
/// batch and for batches that are all the same). Throws Error unless 1 ≤ batches ≤ n.
Estimate mean_of_batches(const IndependentRun& run, std::uint64_t n, std::uint64_t batches, RandomStream& random);

/// An estimator in batches of about `size` samples each (one batch for fewer than 2 `size` samples).
template <int D>
Estimator<D> in_batches_of(std::string id, const Estimator<D>& estimator, std::uint64_t size);

/// An estimator whose n is the size of a batch: the mean of max(1, total/n) batches, about `total` samples at every n.
template <int D>
Estimator<D> batches_sharing(std::string id, const Estimator<D>& estimator, std::uint64_t total);

}  // namespace plumb
