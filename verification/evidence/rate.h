#pragma once

#include "core/interval.h"
#include "verification/evidence/convergence.h"
#include "verification/run.h"
#include "verification/verdict.h"

namespace plumb {

/// The verdict on whether the MSE falls with an exponent in this interval over the setting's range of n, and between any
/// two of its counts. It holds when the (1−beta) interval of the slope lies inside and a step or bend is excluded that is
/// larger than the interval's half width makes over the range; it is refuted when the slope's interval is
/// disjoint, or that of the exponent between two counts, or where tails widen these, when four fresh runs say so at the
/// fourth root of the level. docs/statistics.md, "Rates".
Verdict rate_is(const Replicate& replicate, const ConvergenceSetting& setting, const Interval& exponents,
                const Run& run);

}  // namespace plumb
