#pragma once

#include <optional>

#include "analytic/integrand.h"
#include "core/interval.h"

namespace plumb {

/// The exponent of the MSE of cell-weighted estimators in 1D, ± 0.25 for what is not yet asymptotic. A cell errs by its
/// length times the change of f across it: N^-2 in squares for the one cell at a jump, N^-4 at a kink, and N·N^-6 for
/// all cells of a smooth f. Empty for unbounded integrands and for constants. docs/statistics.md, "Rates".
using ExpectedSlope = std::optional<Interval> (*)(const Integrand<1>&);

/// Periodic cells: the smoothness that counts is that on the circle.
std::optional<Interval> torus_slope_1d(const Integrand<1>& f);
/// Periodic cells of f∘φ: φ leaves no jump at the ends, but a kink unless f' vanishes there too.
std::optional<Interval> tent_slope_1d(const Integrand<1>& f);
/// Clipped cells, whose ends cost N^-2 in error as a kink does.
std::optional<Interval> clipped_slope_1d(const Integrand<1>& f);
/// Clipped cells over their expected length: an end cell is off by a random factor of order 1, as at a jump of f from
/// f(0), f(1) to 0.
std::optional<Interval> divided_slope_1d(const Integrand<1>& f);
/// Clipped cells over their expected length under a density with steps, each of which acts as an end does.
std::optional<Interval> stepped_density_slope_1d(const Integrand<1>& f);

}  // namespace plumb
