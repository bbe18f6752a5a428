#pragma once

#include <cstdint>

#include "core/interval.h"

namespace plumb {

/// The probability distributions behind the verdicts, by Boost.Math. Tails are computed as tails, never as 1 − cdf.

/// The z with P(Z > z) = tail for a standard normal Z; tail in (0, 1).
double normal_upper_quantile(double tail);
/// The probability P(|Z| > z).
double normal_two_sided_tail(double z);

/// The probability P(|T| > t) for Student's t with k > 0 degrees of freedom, which may be infinite.
double student_two_sided_tail(double t, double degrees_of_freedom);
/// The t with P(T > t) = tail.
double student_upper_quantile(double tail, double degrees_of_freedom);

/// The probability P(X < x) for chi-square with k degrees of freedom.
double chi_square_lower_tail(double x, double degrees_of_freedom);
/// The probability P(X > x) for chi-square with k degrees of freedom.
double chi_square_tail(double x, double degrees_of_freedom);
/// The x with P(X > x) = tail.
double chi_square_upper_quantile(double tail, double degrees_of_freedom);

/// The upper (1 − beta) confidence bound of the noncentrality of a chi-square variable observed at x: the largest
/// noncentrality under which a value ≤ x still has probability beta; 0 when none has. Above x = 1e8 the bound may be
/// larger than that, by at most the degrees of freedom.
double noncentrality_upper_bound(double x, double degrees_of_freedom, double beta);

/// The interval of a probability after `successes` of `trials` [Clopper & Pearson 1934], each end wrong with at most
/// `tail`.
Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double tail);

}  // namespace plumb
