#pragma once

#include <cmath>
#include <optional>

#include "analytic/integrand.h"
#include "core/interval.h"

namespace plumb {

/// The exponent of a mean of independent samples whose weights are bounded: MSE = variance/n, where there is a
/// variance.
template <int D>
std::optional<Interval> independent_slope(const Integrand<D>& f) {
    if (!std::isfinite(f.variance_value())) return {};
    return Interval{-1, -1};
}

}  // namespace plumb
