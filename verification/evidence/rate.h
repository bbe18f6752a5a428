#pragma once

#include "core/interval.h"
#include "verification/evidence/convergence.h"
#include "verification/run.h"
#include "verification/verdict.h"

namespace plumb {

/// The verdict on whether the MSE falls with an exponent in this interval over the setting's range of n. It holds when
/// the (1−beta) interval of the slope lies inside, and is refuted when the (1−alpha) interval is disjoint.
/// docs/statistics.md, "Rates".
Verdict rate_is(const Replicate& replicate, const ConvergenceSetting& setting, const Interval& exponents,
                const Run& run);

}  // namespace plumb
