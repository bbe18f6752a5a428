#include "checks/bsdf/sphere_grid.h"

#include <algorithm>
#include <numbers>

#include "core/error.h"

namespace plumb::checks {
namespace {

using std::numbers::pi;

void add_graded(std::vector<double>& ends, double centre, double scale, double low, double high) {
    if (centre > low && centre < high) ends.push_back(centre);
    for (double distance = scale; distance < high - low; distance *= 4)
        for (const double end : {centre - distance, centre + distance})
            if (end > low && end < high) ends.push_back(end);
}

void sort_apart(std::vector<double>& ends, double least) {
    std::ranges::sort(ends);
    std::vector<double> kept{ends.front()};
    for (const double end : ends)
        if (end - kept.back() > least) kept.push_back(end);
    kept.back() = ends.back();
    ends = std::move(kept);
}

std::size_t interval_of(const std::vector<double>& ends, double x) {
    const auto above = std::ranges::upper_bound(ends, x) - ends.begin();
    return static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(ends.size()) - 2));
}

}  // namespace

SphereGrid::SphereGrid(Vec3 wo, double roughness, double eta)
    : polar_{0, pi / 2, pi}, azimuth_{-pi, -pi / 2, pi / 2, pi} {
    if (!(roughness >= 1e-6 && roughness <= 1))
        throw Error(fmt::format(
            "roughness is {}; accepted: 1e-6 to 1, the narrowest smooth lobe's, 1 where all are discrete", roughness));
    if (!(eta > 0 && std::isfinite(eta))) throw Error(fmt::format("eta is {}; an index above 0 is accepted", eta));
    const double sine = std::hypot(wo.x, wo.y), tilt = std::atan2(sine, std::abs(wo.z));
    forward_ = sine > 0 ? Vec3{-wo.x / sine, -wo.y / sine, 0} : Vec3{1, 0, 0};
    const double scale = roughness / 2, across = wo.z > 0 ? eta : 1 / eta;
    const double mirror = wo.z > 0 ? tilt : pi - tilt;
    add_graded(polar_, mirror, scale, 0, pi);
    add_graded(polar_, pi / 2, scale, 0, pi);
    if (const double refracted = sine / across; eta != 1 && refracted < 1)
        add_graded(polar_, wo.z > 0 ? pi - std::asin(refracted) : std::asin(refracted), scale, 0, pi);
    add_graded(azimuth_, 0, scale * std::max(1e-3, std::abs(wo.z)), -pi, pi);
    sort_apart(polar_, scale / 1000);
    sort_apart(azimuth_, 0);
    for (std::size_t i = 0; i + 1 < polar_.size(); ++i)
        for (std::size_t j = 0; j + 1 < azimuth_.size(); ++j)
            rectangles_.push_back({polar_[i], polar_[i + 1], azimuth_[j], azimuth_[j + 1]});
}

std::size_t SphereGrid::index(Vec3 w) const {
    const double polar = std::atan2(std::hypot(w.x, w.y), w.z);
    const double azimuth = std::atan2(forward_.x * w.y - forward_.y * w.x, dot(forward_, w));
    return interval_of(polar_, polar) * (azimuth_.size() - 1) + interval_of(azimuth_, azimuth);
}

Vec3 SphereGrid::direction(double polar, double azimuth) const {
    const double c = std::cos(azimuth), s = std::sin(azimuth), radius = std::sin(polar);
    return {radius * (c * forward_.x - s * forward_.y), radius * (c * forward_.y + s * forward_.x), std::cos(polar)};
}

}  // namespace plumb::checks
