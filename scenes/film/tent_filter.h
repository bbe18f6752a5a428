#pragma once

#include <algorithm>

#include "scenes/film/filter_model.h"

namespace plumb {

/// The density (1 − |x|/r)/r on [−r, r].
class TentFilter {
public:
    static constexpr std::array plugins{description::Plugin{"tent", "falls linearly to the ends of its support"}};
    static TentFilter load(description::Properties& properties);

    explicit TentFilter(double radius = 1);
    /// The point at which the CDF is u, as a root from the nearer end, so that nothing cancels.
    [[nodiscard]] double sample(double u) const {
        return u < 0.5 ? radius_ * (std::sqrt(2 * u) - 1) : radius_ * (1 - std::sqrt(2 * (1 - u)));
    }
    [[nodiscard]] double pdf(double x) const { return std::max(0.0, 1 - std::abs(x) / radius_) / radius_; }
    [[nodiscard]] double invert(double x) const {
        const double end = std::max(0.0, 1 - std::abs(x) / radius_);
        return x < 0 ? end * end / 2 : 1 - end * end / 2;
    }
    [[nodiscard]] double radius() const { return radius_; }

private:
    double radius_;
};

}  // namespace plumb
