#pragma once

#include <limits>

namespace plumb {

/// A closed interval; the default says nothing: it holds every real number.
struct Interval {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    [[nodiscard]] constexpr bool contains(double x) const { return low <= x && x <= high; }
    [[nodiscard]] constexpr bool inside(const Interval& outer) const { return outer.low <= low && high <= outer.high; }
    [[nodiscard]] constexpr bool disjoint(const Interval& other) const { return high < other.low || other.high < low; }
    [[nodiscard]] constexpr double width() const { return high - low; }
    [[nodiscard]] constexpr bool bounded() const {
        return low > -std::numeric_limits<double>::infinity() && high < std::numeric_limits<double>::infinity();
    }
    friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

}  // namespace plumb
