#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace plumb {

// One-dimensional densities on [0,1], as values. Of each, three functions that belong together:
//   sample(u)  maps u in [0,1), uniform, to a point with this density (increasing: the inverse CDF);
//   pdf(x)     is that density, 0 outside [0,1];
//   invert(x)  is the u that sample() maps to x: the CDF.

/// The uniform density, 1.
struct UniformDensity {
    [[nodiscard]] double sample(double u) const { return u; }
    [[nodiscard]] double pdf(double x) const { return 0 <= x && x <= 1 ? 1 : 0; }
    [[nodiscard]] double invert(double x) const { return std::clamp(x, 0.0, 1.0); }
};

/// The density proportional to the line from `at_0` to `at_1`, both ≥ 0 and not both 0.
class LinearDensity {
public:
    LinearDensity(double at_0, double at_1) {
        const double largest = std::max(at_0, at_1);
        if (!(at_0 >= 0 && at_1 >= 0 && largest > 0 && std::isfinite(largest)))
            throw Error(
                fmt::format("linear density from {} to {}: both must be >= 0, finite, and one > 0", at_0, at_1));
        const double half_sum = (at_0 / largest + at_1 / largest) / 2;
        a_ = at_0 / largest / half_sum;
        b_ = at_1 / largest / half_sum;
    }

    /// The root of x (a + (b − a) x/2) = u, written without cancellation; a + b = 2.
    [[nodiscard]] double sample(double u) const {
        if (u <= 0) return 0;
        return std::min(1.0, 2 * u / (a_ + std::sqrt((1 - u) * a_ * a_ + u * b_ * b_)));
    }
    [[nodiscard]] double pdf(double x) const { return 0 <= x && x <= 1 ? (1 - x) * a_ + x * b_ : 0; }
    [[nodiscard]] double invert(double x) const {
        x = std::clamp(x, 0.0, 1.0);
        return x * ((1 - x / 2) * a_ + x / 2 * b_);
    }

private:
    double a_, b_;  // the density at 0 and 1
};

/// The density λ e^(−λx) / (1 − e^(−λ)) on [0,1]; λ < 0 rises, λ = 0 is uniform, |λ| ≤ 700.
class TruncatedExponential {
public:
    explicit TruncatedExponential(double rate) : rate_(rate), scale_(std::expm1(-rate)) {
        if (!(std::abs(rate) <= 700))
            throw Error(fmt::format("truncated exponential of rate {}: accepted are -700 to 700", rate));
    }

    [[nodiscard]] double sample(double u) const {
        return rate_ == 0 ? u : std::clamp(-std::log1p(u * scale_) / rate_, 0.0, 1.0);
    }
    [[nodiscard]] double pdf(double x) const {
        if (!(0 <= x && x <= 1)) return 0;
        return rate_ == 0 ? 1 : -rate_ / scale_ * std::exp(-rate_ * x);
    }
    [[nodiscard]] double invert(double x) const {
        x = std::clamp(x, 0.0, 1.0);
        return rate_ == 0 ? x : std::expm1(-rate_ * x) / scale_;
    }

private:
    double rate_, scale_;  // scale = e^(−λ) − 1
};

}  // namespace plumb
