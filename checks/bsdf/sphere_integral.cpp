#include "checks/bsdf/sphere_integral.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb::checks {
namespace {

using std::numbers::pi;

constexpr double tolerance = 2e-5;

// Quarters of both hemispheres: the horizon, where most functions break off, is an edge of theirs. Towards it they are
// cut at |wo.z| and four times as far each: on that scale densities rise or fall within grazing directions.
std::vector<Rectangle> quarters(Vec3 wo) {
    std::vector<double> polar{0, pi / 2, pi};
    for (double distance = std::max(1e-4, std::abs(wo.z)); distance < 1; distance *= 4)
        for (const double side : {-1, 1}) polar.push_back(pi / 2 + side * distance);
    std::ranges::sort(polar);
    std::vector<Rectangle> all;
    for (std::size_t i = 0; i + 1 < polar.size(); ++i)
        for (const double azimuth : {-pi, -pi / 2, 0.0, pi / 2})
            all.push_back({polar[i], polar[i + 1], azimuth, azimuth + pi / 2});
    return all;
}

}  // namespace

SphereIntegral::SphereIntegral(Vec3 wo, const std::function<double(Vec3)>& f, std::span<const Vec3> met,
                               std::size_t evaluations, double largest) {
    const double sine = std::hypot(wo.x, wo.y);
    forward_ = sine > 0 ? Vec3{-wo.x / sine, -wo.y / sine, 0} : Vec3{1, 0, 0};
    std::vector<Place> places;
    for (const Vec3 w : met) places.push_back(place(w));
    cubature_ = integrate([&](double polar, double azimuth) { return f(direction(polar, azimuth)) * std::sin(polar); },
                          quarters(wo), places, {tolerance, evaluations, largest});
}

Vec3 SphereIntegral::middle(std::size_t i) const {
    const Rectangle& r = part(i).rectangle;
    return direction((r.x_low + r.x_high) / 2, (r.y_low + r.y_high) / 2);
}

Place SphereIntegral::place(Vec3 w) const {
    return {std::atan2(std::hypot(w.x, w.y), w.z), std::atan2(forward_.x * w.y - forward_.y * w.x, dot(forward_, w))};
}

Vec3 SphereIntegral::direction(double polar, double azimuth) const {
    const double c = std::cos(azimuth), s = std::sin(azimuth), radius = std::sin(polar);
    return {radius * (c * forward_.x - s * forward_.y), radius * (c * forward_.y + s * forward_.x), std::cos(polar)};
}

}  // namespace plumb::checks
