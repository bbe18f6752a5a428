#pragma once

#include <optional>

#include "analytic/integrand.h"
#include "core/interval.h"

namespace plumb {

// Exponents of the MSE of means over point sets that theory gives for an integrand of stated smoothness, for n over
// powers of two and up to logarithms; an interval where the class alone does not decide, empty where we know no theory
// (unbounded integrands, apart from independent points: estimators/replicates/independent_slope.h). Derivations:
// point_set_slopes.cpp.

template <int D>
std::optional<Interval> stratified_slope(const Integrand<D>& f);

std::optional<Interval> latin_hypercube_slope(const Integrand<2>& f);

std::optional<Interval> multi_jittered_slope(const Integrand<2>& f);

/// Halton, Hammersley, Sobol and (0,2) as they are, randomly shifted or xored: no averaging within the set.
template <int D>
std::optional<Interval> low_discrepancy_slope(const Integrand<D>& f);

/// Nested uniform scrambling of a (0,D)-sequence in base 2.
template <int D>
std::optional<Interval> owen_slope(const Integrand<D>& f);

}  // namespace plumb
