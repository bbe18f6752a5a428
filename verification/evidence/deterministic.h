#pragma once

#include <string>
#include <vector>

#include "verification/verdict.h"

namespace plumb {

/// These verdicts need no randomness. All of them print both operands in the reason.

/// The verdict on an exact claim: equality in rational arithmetic or of integers, over `cases` cases. A failure names
/// the first case that differs (empty when none does).
Verdict exactly(bool equal, std::uint64_t cases, std::string statement_of_result);

/// One case of a bounded claim: every |found − truth| / scale lies below the bound (scale 1: absolute). NaN refutes.
struct BoundedCase {
    std::string name;
    double error;  ///< already |found − truth| in the claim's unit
    double x = 0;  ///< place on the corpus' axis, for the stability plot
};
Verdict within_bound(const std::vector<BoundedCase>& cases, double bound, std::string unit);

/// The same verdict, recorded as a stability plot of the formula over its hard cases.
Verdict stable(const std::vector<BoundedCase>& cases, double bound, std::string formula, std::string axis,
               std::string unit = "ulp");

/// The verdict on a cost: counted operations against an exact value or an interval.
Verdict cost_is(double counted, const Interval& claimed, std::string what);

/// The verdict that holds when another one came out as demanded: "an integrand of infinite variance ends undecided".
Verdict outcome_is(const Verdict& inner, Outcome demanded);

/// The error |found − truth| in units in the last place of truth (double); 0 for equal values, infinity for NaN.
double ulp_error(double found, double truth);

}  // namespace plumb
