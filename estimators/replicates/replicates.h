#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "core/error.h"
#include "core/estimate.h"
#include "estimators/estimator.h"
#include "estimators/replicates/mean_of_runs.h"

namespace plumb {

/// The error bar of any randomised estimator: MeanOfRuns of R independent runs with n samples each. It does not see a
/// bias. run(f, n, random) returns an Estimate. Throws Error for no run at all and for a run whose value is NaN.
template <int D, class EstimatorRun>
Estimate replicated(const EstimatorRun& run, const Function<D>& f, std::uint64_t n, std::uint64_t replicates,
                    RandomStream& random) {
    if (replicates == 0) throw Error("replicated: 0 replicates; at least one is needed, two for an error bar");
    MeanOfRuns mean;
    for (std::uint64_t r = 0; r < replicates; ++r) {
        const Estimate one = run(f, n, random);
        if (std::isnan(one.value)) throw Error(fmt::format("replicate {}: its value is NaN; a number is needed", r));
        mean.add(one);
    }
    return mean.estimate();
}

}  // namespace plumb
