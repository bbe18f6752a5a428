#pragma once

#include "estimators/estimator.h"

namespace plumb {

/// The line through (0, f(0)) and (1, f(1)).
struct EndpointLine {
    double at_0 = 0, at_1 = 0;
    [[nodiscard]] double operator()(double x) const { return at_0 + (at_1 - at_0) * x; }
    [[nodiscard]] double integral() const { return (at_0 + at_1) / 2; }
};

/// Two evaluations of f; throws Error where f is not finite at an end.
EndpointLine endpoint_line(const Function<1>& f);

/// Σ w_i (f − ℓ)(x_i) + ∫ ℓ with w = |V|/g: unbiased for i.i.d. uniform samples, and since f − ℓ vanishes at both ends
/// the random factor of the boundary cells no longer costs anything: N^-4 for continuous f. Evaluates f N + 2 times.
Estimate control_variate_estimate_1d(const Function<1>& f, std::span<const double> samples);

}  // namespace plumb
