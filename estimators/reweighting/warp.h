#pragma once

#include <utility>

#include "estimators/estimator.h"

namespace plumb {

/// F(u) = f(x)/p(x) at x = density.sample(u), whose integral over u is ∫ f: any estimator for uniform samples becomes
/// one for samples of p, for every density with sample and pdf (density.h, step_density.h). p > 0 wherever f is not 0.
template <class Density>
Function<1> warped(Function<1> f, Density density) {
    return [f = std::move(f), density = std::move(density)](const Point<1>& u) {
        const double x = density.sample(u[0]);
        return f({x}) / density.pdf(x);
    };
}

}  // namespace plumb
