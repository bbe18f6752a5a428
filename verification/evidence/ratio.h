#pragma once

#include <string>

#include "core/interval.h"
#include "verification/evidence/mean.h"
#include "verification/series.h"

namespace plumb {

/// A claim that variance × cost of one estimator, over that of another, lies in this interval.
struct RatioClaim {
    Interval ratio;  ///< of (variance × cost) of a to that of b
    double cost_a = 1, cost_b = 1;
    /// At least: no fewer than least_draws_without_bounds are made, and a refutation must be confirmed on
    /// confirming_draws() fresh ones, unless …
    std::uint64_t replicates = 10000;
    std::string why_fewer = {};  ///< … the claim says why so few meet all values that matter
};

/// The verdict on whether variance × cost of a, over that of b, is in the interval: from independent replicates of
/// both, by the log ratio and its standard error sqrt((k_a − 1)/R + (k_b − 1)/R), k the kurtosis. Undecided where the
/// squares' tails or a memory of the draws make that worthless. docs/statistics.md, "Ratios".
Verdict ratio_is(const Draw& a, const Draw& b, const RatioClaim& claim, const Run& run);

/// The verdict on whether the MSE of a over that of b, at the last n of both, is in the interval, from what independent
/// replicates gave. Throws std::logic_error where that n is not the same.
Verdict mse_ratio_is(const Series& a, const Series& b, const Interval& ratio, const Run& run);

/// The verdict on whether the variance of draw is the stated one, within a relative delta. The number of replicates and
/// why_fewer are as of a RatioClaim.
Verdict variance_is(const Draw& draw, double variance, double relative_delta, std::uint64_t replicates, const Run& run,
                    const std::string& why_fewer = {});

}  // namespace plumb
