#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/point.h"

namespace plumb {

// Pixel filters as densities of the offset from a pixel's centre, in pixels: of integral 1 along each axis, and
// sampled. A pixel is the plain mean of its own samples, drawn by its filter [Ernst, Stamminger & Greiner 2006]: no
// weights, hence no division by summed weights, which is a ratio and biased. One axis, as in
// estimators/densities/density.h:
//   sample(u), pdf(x), invert(x), radius().

/// Constant on [−½, ½] (Mitsuba's `box`).
struct BoxFilter {
    [[nodiscard]] double sample(double u) const { return u - 0.5; }
    [[nodiscard]] double pdf(double x) const { return -0.5 <= x && x <= 0.5 ? 1 : 0; }
    [[nodiscard]] double invert(double x) const { return std::clamp(x + 0.5, 0.0, 1.0); }
    [[nodiscard]] double radius() const { return 0.5; }
};

/// (1 − |x|/r)/r on [−r, r].
class TentFilter {
public:
    explicit TentFilter(double radius = 1);
    /// The root of the CDF from the nearer end: no cancellation.
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

/// The normal density of this standard deviation, cut at four of them. (Mitsuba subtracts e^-8 so that it ends at 0,
/// which moves less than 4e-4 of the mass.)
class GaussianFilter {
public:
    explicit GaussianFilter(double standard_deviation = 0.5);
    [[nodiscard]] double sample(double u) const;
    [[nodiscard]] double pdf(double x) const;
    [[nodiscard]] double invert(double x) const;
    [[nodiscard]] double radius() const { return 4 * sigma_; }

private:
    double sigma_;
};

using Filter = std::variant<BoxFilter, TentFilter, GaussianFilter>;

/// By how many pixels film points reach beyond the outermost pixels.
inline double margin(const Filter& filter) {
    return std::visit([](const auto& f) { return std::max(0.0, f.radius() - 0.5); }, filter);
}

/// A film point for the pixel with its corner at `pixel`.
inline Point<2> sample_film(const Filter& filter, const Point<2>& pixel, const Point<2>& u) {
    return std::visit(
        [&](const auto& f) {
            return Point<2>{pixel[0] + 0.5 + f.sample(u[0]), pixel[1] + 0.5 + f.sample(u[1])};
        },
        filter);
}

}  // namespace plumb
