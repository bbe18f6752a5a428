#include "checks/bsdf/directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb::checks {

std::vector<Vec3> check_directions() {
    std::vector<Vec3> directions;
    const auto add = [&](double degrees, double side) {
        const double tilt = degrees * std::numbers::pi / 180, turn = 2.4 * static_cast<double>(directions.size());
        directions.push_back({std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), side * std::cos(tilt)});
    };
    for (const double degrees : {0., 10., 20., 30., 40., 50., 60., 70., 75., 80., 83., 85., 87., 88.5, 89.5})
        add(degrees, 1);
    for (const double degrees : {0., 15., 30., 40., 43., 50., 60., 75., 85., 89.5}) add(degrees, -1);
    return directions;
}

std::string name_of(Vec3 direction) {
    const double degrees = std::acos(std::min(1.0, std::abs(direction.z))) * 180 / std::numbers::pi;
    return fmt::format("{:.3g}° {}", degrees, direction.z > 0 ? "outside" : "inside");
}

}  // namespace plumb::checks
