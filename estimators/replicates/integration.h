#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/error_target.h"
#include "core/estimate.h"
#include "estimators/replicates/batches.h"

namespace plumb {

/// Independent runs of one method with n samples each, in order.
struct Runs {
    std::uint64_t n = 0;
    std::vector<Estimate> estimates;
    double seconds = 0;  ///< mean per run, a side record
};

/// `count` runs on the threads that for_batches may use. Run r draws from the stream (seed, purpose and n, r): sets of
/// runs with another purpose or n are independent.
Runs independent_runs(const IndependentRun& run, std::uint64_t n, std::uint64_t count, std::uint64_t seed,
                      std::string_view purpose);

/// The mean of the runs with the error that their spread shows: MeanOfRuns of them.
Estimate mean_of(const Runs& runs);

/// Whether the runs' skewness is too large for a 95 % interval of value ± 2 errors to mean what it says: |skewness| z³
/// / (3 √R) > 1, the guard that mean claims have (docs/statistics.md, "Heavy tails"). An integrand of infinite variance
/// shows itself so, mostly; tails that no run met show nowhere.
bool skewed(const Runs& runs);

/// No error is believed from fewer evaluations than these in all runs: a part of the domain that holds a share
/// of 2.4e-4 and was met by none (e^-16 of the time) would show in no spread.
inline constexpr std::uint64_t least_evaluations = std::uint64_t{1} << 16;

/// The sample counts that were looked at on the way to a target, the last one chosen.
struct Search {
    std::vector<Runs> looks;
    bool met = false;  ///< false: max_evaluations would have been exceeded first
};

/// Doubles n from 16 until the standard error of `replicates` runs that are not skewed and have least_evaluations is at
/// most 2/3 of the target, or until another doubling and an answer of its size would need more than max_evaluations in
/// all. The looks decide n and so know too little about their own error: the smallest of many noisy errors stops the
/// search. Report fresh runs at the chosen n: their mean is as unbiased as the method, their error as honest as for an
/// n fixed beforehand; 2/3 leaves room for it to meet the target too (for normal runs and 32 replicates a fresh
/// variance is 2.25 times that of a look with probability 1.4 %). `progress` is told of every look.
Search search_sample_count(const IndependentRun& run, const ErrorTarget& target, std::uint64_t replicates,
                           std::uint64_t max_evaluations, std::uint64_t seed,
                           const std::function<void(const Runs& look)>& progress = {});

}  // namespace plumb
