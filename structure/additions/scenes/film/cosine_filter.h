#pragma once

#include <numbers>

#include "scenes/film/filter_model.h"

namespace plumb {

/// π/(4r) cos(πx/2r) on [−r, r], whose CDF is (1 + sin(πx/2r))/2.
class CosineFilter {
public:
    static constexpr std::array plugins{description::Plugin{"cosine", "falls as a cosine to the ends of its support"}};
    static CosineFilter load(description::Properties& properties);

    explicit CosineFilter(double radius = 1);
    [[nodiscard]] double sample(double u) const { return std::asin(2 * u - 1) / scale_; }
    [[nodiscard]] double pdf(double x) const { return std::abs(x) < radius_ ? scale_ / 2 * std::cos(scale_ * x) : 0; }
    [[nodiscard]] double invert(double x) const {
        if (std::abs(x) >= radius_) return x < 0 ? 0 : 1;
        return (1 + std::sin(scale_ * x)) / 2;
    }
    [[nodiscard]] double radius() const { return radius_; }

private:
    double radius_, scale_;  // scale: π/2r
};

}  // namespace plumb
