#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace plumb::reports {

/// A logarithmic axis of a plot, which maps positive values to places.
struct LogAxis {
    double low = 0, high = 1;  ///< logarithms of the domain's ends
    double from = 0, to = 1;   ///< places of these
    double operator()(double x) const { return from + (std::log(x) - low) / (high - low) * (to - from); }
};

/// The axis over these positive values and a little more; over [1, e] where there are none.
LogAxis axis_over(const std::vector<double>& values, double from, double to);

struct Tick {
    double at = 0;
    std::string text;
};

/// The ticks of an axis: at most about `most` powers of ten, or of two; 1, 2 and 5 times powers of ten where fewer than
/// two powers would do.
std::vector<Tick> ticks(const LogAxis& axis, bool powers_of_two, int most);

}  // namespace plumb::reports
