#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/interval.h"
#include "core/random.h"
#include "verification/run.h"
#include "verification/verdict.h"

namespace plumb {

/// One independent value whose expectation is on trial (a replicate of an estimator, a sample's contribution).
/// It takes all its randomness from the stream, which is its own.
using Draw = std::function<double(RandomStream&)>;

/// A claim that an expectation is the reference, within epsilon.
struct MeanClaim {
    double reference = 0;
    double delta = 0;    ///< the bias that `holds` excludes; absolute, in the unit of the values
    double epsilon = 0;  ///< the bias the claim itself allows: rounding, the reference's own error
    Interval bounds{};   ///< of one value, where known: then every risk is exact in finite samples
    /// Values that can spike unseen: at least 16 / P(spike). Without bounds on both sides never less than
    /// least_draws_without_bounds, and a refutation must be confirmed on confirming_draws() fresh values, unless …
    std::uint64_t min_samples = 0;
    std::string why_fewer = {};  ///< … the claim says why min_samples meet all values that matter: part of the evidence
    std::uint64_t cap = std::uint64_t{1} << 24;  ///< at least 100 (sigma/delta)²; docs/statistics.md, "Budget"
    bool zero_variance = false;                  ///< every value is claimed to be the reference itself (within epsilon)
};

/// The verdict on whether the expectation of draw is the reference: sequential, anytime-valid, by betting.
/// docs/statistics.md, "Mean claims". Undecided, with what shows it, where the draws are not independent (Independence).
Verdict mean_is(const Draw& draw, const MeanClaim& claim, const Run& run);

/// A claim that an expectation is at most a bound.
struct AtMostClaim {
    double bound = 0;   ///< the expectation is claimed to be at most this
    double margin = 0;  ///< how far below it is expected to lie; sets the size of the bets, not the risks
    Interval bounds{};  ///< of one value, where known
    std::uint64_t cap = std::uint64_t{1} << 24;
    std::uint64_t min_samples = 0;  ///< as of a MeanClaim
    std::string why_fewer = {};     ///< likewise
};

/// The verdict on whether the expectation of draw is at most the bound: the same test with one side left open.
Verdict mean_at_most(const Draw& draw, const AtMostClaim& claim, const Run& run);

}  // namespace plumb
