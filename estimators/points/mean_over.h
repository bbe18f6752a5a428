#pragma once

#include <vector>

#include "core/estimate.h"
#include "core/point.h"
#include "estimators/estimator.h"

namespace plumb {

/// The mean of f over a point set. Its points depend on each other, so the set alone says nothing of the error: the
/// standard error is infinite (see replicates.h). A value +inf or −inf passes into the mean; throws Error for NaN,
/// naming the sample, and for an empty set.
template <int D>
Estimate mean_over(const std::vector<Point<D>>& points, const Function<D>& f);

/// The mean of f over independent points, whose spread gives the standard error (infinite for one point).
template <int D>
Estimate mean_over_independent(const std::vector<Point<D>>& points, const Function<D>& f);

}  // namespace plumb
