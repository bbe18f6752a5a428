#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "core/interval.h"
#include "estimators/estimator.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"

// The claims of reweighting in the unit square share what follows. Biases of mutants were measured with 4·10^4 samples
// or more, those that g predicts computed; delta lies at a half to a quarter of the smallest.

namespace plumb::suites {

using Samples = std::vector<Point<2>>;
using Weigh = std::function<std::vector<double>(std::span<const Point<2>>)>;

/// The integrand of most claims, e^(x+y): not linear, not periodic, its normal derivative nowhere 0 on the boundary.
double exp_sum(const Point<2>& x);
inline const double exp_sum_integral = std::pow(std::expm1(1.0), 2);
inline const Interval exp_sum_bounds{1, std::exp(2.0)};  ///< of every weighted sum, too, whose weights sum to 1

/// A weighted sum of n independent samples.
Draw weighted(const Function<2>& f, std::uint64_t n, const Weigh& weigh);

// Wrong cells serve as mutants.

/// Cells with periodic copies on three sides only; what is not cut off reaches to −1.
std::vector<double> copies_missing_on_the_left(std::span<const Point<2>> samples);
/// Cells with periodic copies only to the left, right, below and above.
std::vector<double> diagonal_copies_missing(std::span<const Point<2>> samples);
/// Cells cut off at −1 and 2, not at 0 and 1.
std::vector<double> not_clipped(std::span<const Point<2>> samples);
/// Cells of which each of several coincident samples gets the whole clipped one.
std::vector<double> coincident_counted_fully(std::span<const Point<2>> samples);

}  // namespace plumb::suites
