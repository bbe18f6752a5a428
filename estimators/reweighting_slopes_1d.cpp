#include "estimators/reweighting_slopes_1d.h"

#include <cmath>

namespace plumb {
namespace {

Interval around(double exponent) {
    return {exponent - 0.25, exponent + 0.25};
}

}  // namespace

std::optional<Interval> torus_slope_1d(const Integrand<1>& f) {
    switch (f.periodic_smoothness) {
        case Smoothness::analytic: return around(-5);
        case Smoothness::kink: return around(-4);
        case Smoothness::jump: return around(-2);
        case Smoothness::singular: return {};
    }
    return {};
}

std::optional<Interval> tent_slope_1d(const Integrand<1>& f) {
    switch (f.smoothness) {
        case Smoothness::analytic: return Interval{-5.25, -3.75};
        case Smoothness::kink: return around(-4);
        case Smoothness::jump: return around(-2);
        case Smoothness::singular: return {};
    }
    return {};
}

std::optional<Interval> clipped_slope_1d(const Integrand<1>& f) {
    return tent_slope_1d(f);
}

std::optional<Interval> divided_slope_1d(const Integrand<1>& f) {
    if (f.smoothness == Smoothness::singular) return {};
    const double scale = 1e-12 * std::hypot(f.integral_value(), std::sqrt(f.variance_value()));
    const bool vanishes = std::abs(f({0.0})) <= scale && std::abs(f({1.0})) <= scale;
    return vanishes ? clipped_slope_1d(f) : around(-2);
}

}  // namespace plumb
