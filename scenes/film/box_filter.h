#pragma once

#include <algorithm>

#include "scenes/film/filter_model.h"

namespace plumb {

/// The filter that is constant on [−½, ½] (Mitsuba's `box`).
struct BoxFilter {
    static constexpr std::array plugins{description::Plugin{"box", "constant over its support"}};
    static BoxFilter load(description::Properties& properties);

    [[nodiscard]] double sample(double u) const { return u - 0.5; }
    [[nodiscard]] double pdf(double x) const { return -0.5 <= x && x <= 0.5 ? 1 : 0; }
    [[nodiscard]] double invert(double x) const { return std::clamp(x + 0.5, 0.0, 1.0); }
    [[nodiscard]] double radius() const { return 0.5; }
};

}  // namespace plumb
