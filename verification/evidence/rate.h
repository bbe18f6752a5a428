#pragma once

#include "core/interval.h"
#include "verification/evidence/convergence.h"
#include "verification/run.h"
#include "verification/verdict.h"

namespace plumb {

/// Does the MSE fall with an exponent in this interval over the setting's range of n? Holds when the (1−beta) interval
/// of the slope lies inside, refuted when the (1−alpha) interval is disjoint. docs/statistics.md, "Rates".
Verdict rate_is(const Replicate& replicate, const ConvergenceSetting& setting, const Interval& exponents,
                const Run& run);

}  // namespace plumb
