#pragma once

#include "estimators/densities/technique.h"
#include "estimators/estimator.h"
#include "estimators/mis/importance_sampling.h"
#include "estimators/replicates/independent_slope.h"

namespace plumb {

/// Uniform samples and those of another technique in equal shares, as one density of at least 1/2: f/p is at most 2 f.
template <int D>
Technique<D> defensive_technique(const Technique<D>& bold) {
    return {"defensive " + bold.name,
            [bold](Point<D> u) {
                const bool uniform = u[0] < 0.5;
                u[0] = uniform ? 2 * u[0] : 2 * u[0] - 1;
                return uniform ? u : bold.sample(u);
            },
            [bold](const Point<D>& x) { return (1 + bold.pdf(x)) / 2; }};
}

template <int D>
Estimator<D> defensive_estimator(const Technique<D>& bold) {
    return {.id = "importance-defensive",
            .summary = "Importance sampling with the mean of the uniform density and one that is peaked at 0.",
            .source = "ours, estimators/mis/defensive.h",
            .run = [both = defensive_technique<D>(bold)](
                       const Function<D>& f, std::uint64_t n,
                       RandomStream& random) { return importance_sampling<D>(f, both, n, random); },
            .expected_slope = independent_slope<D>};
}

}  // namespace plumb
