#include "checks/bsdf/directions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scenes/bsdfs/bsdf_model.h"

namespace plumb::checks {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180;

// From angles near 0 and 90° alike, without cancellation.
Vec3 at(double sine, double cosine, double turn) {
    const double radius = sine / std::hypot(sine, cosine);
    return {radius * std::cos(2 * pi * turn), radius * std::sin(2 * pi * turn), cosine / std::hypot(sine, cosine)};
}

double angle_between(Vec3 a, Vec3 b) {
    return 2 * std::atan2(length(a - b), length(a + b)) / degree;
}

}  // namespace

std::vector<Vec3> check_directions(const Run& run) {
    constexpr std::array outside{0., 10., 20., 30., 40., 50., 60., 70., 75., 80., 83., 85., 87., 89., 89.97};
    constexpr std::array inside{0., 15., 30., 40., 43., 50., 60., 70., 80., 87., 89.97};
    RandomStream random = run.part("directions").random(0);
    std::vector<Vec3> directions{{0, 0, 1}};
    const auto add = [&](double from, double to, double side) {
        const double tilt = (from + (to - from) * random.uniform()) * degree;
        directions.push_back(at(std::sin(tilt), side * std::cos(tilt), random.uniform()));
    };
    for (std::size_t i = 0; i + 1 < outside.size(); ++i) add(outside[i], outside[i + 1], 1);
    for (std::size_t i = 0; i + 1 < inside.size(); ++i) add(inside[i], inside[i + 1], -1);
    return directions;
}

Vec3 any_direction(RandomStream& random) {
    constexpr double nearest = 1e-4, near = 0.2;
    const double side = random.uniform() < 0.5 ? -1 : 1, kind = random.uniform(), t = random.uniform();
    const double turn = random.uniform(), distance = nearest * std::pow(near / nearest, t);
    if (kind < 0.25) return at(std::cos(distance), side * std::sin(distance), turn);
    if (kind < 0.375) return at(std::sin(distance), side * std::cos(distance), turn);
    return at(std::sin(t * pi / 2), side * std::cos(t * pi / 2), turn);
}

std::string name_of(Vec3 direction) {
    const double tilt = std::atan2(std::hypot(direction.x, direction.y), std::abs(direction.z)) / degree;
    const char* side = direction.z > 0 ? "outside" : direction.z < 0 ? "inside" : "in the surface";
    return fmt::format("{:.4g}° {}", tilt, side);
}

std::string in_words(Vec3 wo, Vec3 wi) {
    const std::array<std::pair<const char*, Vec3>, 4> known{{{"the mirrored direction", mirrored(wo)},
                                                             {"the way back", wo},
                                                             {"the way straight on", -wo},
                                                             {"the normal", {0, 0, std::copysign(1.0, wi.z)}}}};
    const auto nearest =
        *std::ranges::min_element(known, {}, [&](const auto& place) { return angle_between(place.second, wi); });
    return fmt::format("wo {}, wi {}, {:.3g}° from {}", name_of(wo), name_of(wi), angle_between(nearest.second, wi),
                       nearest.first);
}

}  // namespace plumb::checks
