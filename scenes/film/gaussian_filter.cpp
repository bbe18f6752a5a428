#include "scenes/film/gaussian_filter.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <numbers>

namespace plumb {

namespace {

// Doubles are accurate enough; in long doubles, which is Boost's default, it takes three times as long.
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

const double mass_within_four_sigma = std::erf(4 / std::numbers::sqrt2);

}  // namespace

GaussianFilter::GaussianFilter(double standard_deviation)
    : sigma_(positive_size(standard_deviation, "gaussian filter: the standard deviation")) {}

GaussianFilter GaussianFilter::load(description::Properties& properties) {
    const double standard_deviation = properties.number("stddev", 0.5);
    checked_radius(properties, 4 * standard_deviation);
    return GaussianFilter(standard_deviation);
}

double GaussianFilter::sample(double u) const {
    const double x =
        std::numbers::sqrt2 * sigma_ * boost::math::erf_inv((2 * u - 1) * mass_within_four_sigma, InDouble());
    return std::clamp(x, -radius(), radius());
}

double GaussianFilter::pdf(double x) const {
    if (!(std::abs(x) <= radius())) return 0;
    const double z = x / sigma_;
    return std::exp(-z * z / 2) / (sigma_ * std::sqrt(2 * std::numbers::pi) * mass_within_four_sigma);
}

double GaussianFilter::invert(double x) const {
    const double z = std::clamp(x, -radius(), radius()) / sigma_;
    return (1 + std::erf(z / std::numbers::sqrt2) / mass_within_four_sigma) / 2;
}

}  // namespace plumb
