#include "estimators/reweighting/reweighting_slopes_1d.h"

#include <cmath>

namespace plumb {
namespace {

Interval around(double exponent) {
    return {exponent - 0.25, exponent + 0.25};
}

bool has_slope(const Integrand<1>& f) {
    return f.smoothness != Smoothness::singular && f.variance_value() > 0;
}

// The slope that a jump, root or kink forces; that of a smooth integrand as given.
std::optional<Interval> slope_of(Smoothness smoothness, const Interval& smooth) {
    switch (smoothness) {
        case Smoothness::analytic: return smooth;
        case Smoothness::kink: return around(-4);
        case Smoothness::root: return around(-3);
        case Smoothness::jump: return around(-2);
        case Smoothness::singular: return {};
    }
    return {};
}

}  // namespace

std::optional<Interval> torus_slope_1d(const Integrand<1>& f) {
    if (!has_slope(f)) return {};
    return slope_of(f.periodic_smoothness, around(-5));
}

std::optional<Interval> tent_slope_1d(const Integrand<1>& f) {
    if (!has_slope(f)) return {};
    return slope_of(f.smoothness, {-5.25, -3.75});
}

std::optional<Interval> clipped_slope_1d(const Integrand<1>& f) {
    return tent_slope_1d(f);
}

std::optional<Interval> divided_slope_1d(const Integrand<1>& f) {
    if (f.smoothness == Smoothness::singular) return {};
    const double scale = 1e-12 * f.root_mean_square();
    const bool vanishes = std::abs(f({0.0})) <= scale && std::abs(f({1.0})) <= scale;
    return vanishes ? clipped_slope_1d(f) : around(-2);
}

std::optional<Interval> stepped_density_slope_1d(const Integrand<1>& f) {
    if (f.smoothness == Smoothness::singular) return {};
    return around(-2);
}

}  // namespace plumb
