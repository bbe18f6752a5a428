#pragma once

#include <functional>

#include "estimators/estimator.h"

namespace plumb {

/// A warp x = T(u) of [0,1] onto itself with density p(x) = du/dx: T is the inverse of p's distribution function.
struct Warp1D {
    std::function<double(double)> inverse_cdf, pdf;
};

/// F(u) = f(T(u))/p(T(u)), whose integral over u is ∫ f: any estimator for uniform samples becomes one for samples of
/// p. p > 0 wherever f is not 0.
Function<1> warped(Function<1> f, Warp1D warp);

/// The density of slope 2 (1 − at_0): p(x) = at_0 + 2 (1 − at_0) x, 0 < at_0 < 2.
Warp1D linear_warp(double at_0);

}  // namespace plumb
