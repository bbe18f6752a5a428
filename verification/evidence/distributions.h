#pragma once

#include <cstdint>

#include "core/interval.h"

namespace plumb {

/// The probability distributions behind the verdicts, by Boost.Math. Tails are computed as tails, never as 1 − cdf.

/// z with P(Z > z) = tail for a standard normal Z; tail in (0, 1).
double normal_upper_quantile(double tail);
/// P(|Z| > z).
double normal_two_sided_tail(double z);

/// P(|T| > t) for Student's t with k > 0 degrees of freedom, which may be infinite.
double student_two_sided_tail(double t, double degrees_of_freedom);
/// t with P(T > t) = tail.
double student_upper_quantile(double tail, double degrees_of_freedom);

/// P(X < x) for chi-square with k degrees of freedom.
double chi_square_lower_tail(double x, double degrees_of_freedom);
/// P(X > x) for chi-square with k degrees of freedom.
double chi_square_tail(double x, double degrees_of_freedom);
/// x with P(X > x) = tail.
double chi_square_upper_quantile(double tail, double degrees_of_freedom);

/// The upper (1 − beta) confidence bound of the noncentrality of a chi-square variable observed at x: the largest
/// noncentrality under which a value ≤ x still has probability beta; 0 when none has. Above x = 1e8 a bound that is
/// larger by at most the degrees of freedom.
double noncentrality_upper_bound(double x, double degrees_of_freedom, double beta);

/// The interval of [Clopper & Pearson 1934] of a probability after `successes` of `trials`, each end wrong with at most
/// `tail`.
Interval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double tail);

}  // namespace plumb
