#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "core/error.h"
#include "core/estimate.h"
#include "core/moments.h"
#include "estimators/estimator.h"

namespace plumb {

/// The error bar of any randomised estimator: the mean of R independent runs with n samples each, the standard error of
/// that mean from their spread (its square is unbiased for the variance of the mean), all evaluations counted.
/// Infinite for fewer than two runs, and when all runs gave the same value: a deterministic point set repeated shows no
/// spread, and no spread seen says nothing. It does not see a bias. run(f, n, random) returns an Estimate. Throws Error
/// for no run at all and for a run whose value is NaN.
template <int D, class EstimatorRun>
Estimate replicated(const EstimatorRun& run, const Function<D>& f, std::uint64_t n, std::uint64_t replicates,
                    RandomStream& random) {
    if (replicates == 0) throw Error("replicated: 0 replicates; at least one is needed, two for an error bar");
    Moments values;
    Estimate total;
    for (std::uint64_t r = 0; r < replicates; ++r) {
        const Estimate one = run(f, n, random);
        if (std::isnan(one.value)) throw Error(fmt::format("replicate {}: its value is NaN; a number is needed", r));
        values.add(one.value);
        total.evaluations += one.evaluations;
    }
    total.value = values.mean();
    if (values.variance() > 0) total.standard_error = values.standard_error();
    return total;
}

}  // namespace plumb
