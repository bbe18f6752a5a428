#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>

#include "core/point.h"
#include "core/vec3.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {

/// The point to which a map takes a point of the unit square, in space or on the sphere, and the density that it states
/// there.
struct Mapped {
    Vec3 place;
    double pdf;
};
using SquareMap = std::function<std::optional<Mapped>(const Point<2>& u)>;

/// The area |∂x/∂u0 × ∂x/∂u1| that the map gives to a unit of the square, by differences of fourth order.
inline double area_scale(const SquareMap& map, const Point<2>& u) {
    constexpr double h = 1e-5;
    const auto derivative = [&](std::size_t axis) {
        const auto at = [&](double step) {
            Point<2> moved = u;
            moved[axis] += step * h;
            const auto mapped = map(moved);
            return mapped ? mapped->place : Vec3{NAN, NAN, NAN};
        };
        return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
    };
    return length(cross(derivative(0), derivative(1)));
}

/// The verdict that pdf · area_scale = 1 at 200 places, spread by the powers of the plastic number [Roberts 2018];
/// places where the map is empty are passed over.
inline Verdict pdf_is_jacobian(const SquareMap& map) {
    std::vector<BoundedCase> cases;
    for (int i = 1; i <= 200; ++i) {
        const auto spread = [&](double step) { return 0.01 + 0.98 * std::fmod(0.5 + step * i, 1.0); };
        const Point<2> u{spread(0.7548776662466927), spread(0.5698402909980532)};
        if (const auto mapped = map(u))
            cases.push_back({fmt::format("u = ({:.6f}, {:.6f})", u[0], u[1]),
                             std::abs(mapped->pdf * area_scale(map, u) - 1), u[0]});
    }
    if (cases.empty()) cases.push_back({"no place at all", HUGE_VAL});
    return within_bound(cases, 1e-7, "of 1");
}

}  // namespace plumb::suites
