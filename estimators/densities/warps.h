#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/point.h"
#include "core/vec3.h"

namespace plumb {

// Maps from the unit square to shapes. Of each, three functions that belong together, as in
// estimators/densities/density.h:
//   sample_x(u)   maps u, uniform on [0,1)², to a point of the shape;
//   x_pdf(…)      is its density there, in the measure that the comment names, 0 outside the shape;
//   invert_x(p)   is the u that sample_x maps to p.

using std::numbers::pi;

/// The angle of (x, y) in [0, 2π), over 2π.
inline double turn_of(double x, double y) {
    const double turn = std::atan2(y, x) / (2 * pi);
    return turn < 0 ? turn + 1 : turn;
}

/// The unit disk in polar coordinates, r = √u0; per area.
inline Point<2> sample_polar_disk(const Point<2>& u) {
    const double r = std::sqrt(u[0]), phi = 2 * pi * u[1];
    return {r * std::cos(phi), r * std::sin(phi)};
}
inline double polar_disk_pdf(const Point<2>& p) {
    return p[0] * p[0] + p[1] * p[1] <= 1 ? 1 / pi : 0;
}
inline Point<2> invert_polar_disk(const Point<2>& p) {
    return {p[0] * p[0] + p[1] * p[1], turn_of(p[0], p[1])};
}

/// The unit disk with squares about the centre mapped to circles [Shirley & Chiu 1997]; per area. The side of the
/// square becomes the radius, and the way along the side the angle: |dx dy| = r dr dφ = r (π/4)/r da db, with
/// (a, b) = 2u − 1: area scales by π/4 from (a, b), by π from u, everywhere.
inline Point<2> sample_concentric_disk(const Point<2>& u) {
    const double a = 2 * u[0] - 1, b = 2 * u[1] - 1;
    if (a == 0 && b == 0) return {0, 0};
    // From the nearer axis, |phi| ≤ π/4; what follows from `wide`, a coin toss, is chosen without a branch.
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b, phi = pi / 4 * ((wide ? b : a) / r);
    const double along = r * std::cos(phi), across = r * std::sin(phi);
    return {wide ? along : across, wide ? across : along};
}
inline double concentric_disk_pdf(const Point<2>& p) {
    return polar_disk_pdf(p);
}
inline Point<2> invert_concentric_disk(const Point<2>& p) {
    const double r = std::hypot(p[0], p[1]);
    const bool wide = std::abs(p[0]) > std::abs(p[1]);
    const double side = std::copysign(r, wide ? p[0] : p[1]);
    const double along = r == 0 ? 0 : side * 4 / pi * (wide ? std::atan(p[1] / p[0]) : std::atan(p[0] / p[1]));
    return {std::clamp(((wide ? side : along) + 1) / 2, 0.0, 1.0),
            std::clamp(((wide ? along : side) + 1) / 2, 0.0, 1.0)};
}

/// Directions with z ≥ 0 and density z/π per steradian: the disk lifted to the sphere [Malley].
inline Vec3 sample_cosine_hemisphere(const Point<2>& u) {
    const Point<2> p = sample_concentric_disk(u);
    return {p[0], p[1], std::sqrt(std::max(0.0, 1 - p[0] * p[0] - p[1] * p[1]))};
}
inline double cosine_hemisphere_pdf(Vec3 direction) {
    return std::max(0.0, direction.z) / pi;
}
inline Point<2> invert_cosine_hemisphere(Vec3 direction) {
    return invert_concentric_disk({direction.x, direction.y});
}

/// All directions within the angle θ of z, uniform per steradian; the cone is given by 1 − cos θ in (0, 2], which keeps
/// its digits when the cone is narrow. 2 is the whole sphere.
inline Vec3 sample_uniform_cone(const Point<2>& u, double one_minus_cos) {
    const double t = u[0] * one_minus_cos, r = std::sqrt(t * (2 - t)), phi = 2 * pi * u[1];
    return {r * std::cos(phi), r * std::sin(phi), 1 - t};
}
inline double uniform_cone_pdf(Vec3 direction, double one_minus_cos) {
    // 1 − z of a unit vector without cancellation
    const double side = direction.x * direction.x + direction.y * direction.y;
    const double t = direction.z > 0 ? side / (1 + direction.z) : 1 - direction.z;
    return t <= one_minus_cos ? 1 / (2 * pi * one_minus_cos) : 0;
}
inline Point<2> invert_uniform_cone(Vec3 direction, double one_minus_cos) {
    const double side = direction.x * direction.x + direction.y * direction.y;
    const double t = direction.z > 0 ? side / (1 + direction.z) : 1 - direction.z;
    return {std::min(1.0, t / one_minus_cos), turn_of(direction.x, direction.y)};
}

/// All directions, uniform per steradian: the cone that leaves nothing out.
inline Vec3 sample_uniform_sphere(const Point<2>& u) {
    return sample_uniform_cone(u, 2);
}
inline double uniform_sphere_pdf(Vec3) {
    return 1 / (4 * pi);
}
inline Point<2> invert_uniform_sphere(Vec3 direction) {
    return invert_uniform_cone(direction, 2);
}

/// Barycentric coordinates (b1, b2) of a triangle's second and third corner, uniform: density 2 in (b1, b2), so 1/area
/// on the triangle [Turk 1990].
inline Point<2> sample_uniform_triangle(const Point<2>& u) {
    const double root = std::sqrt(u[0]);
    return {root * (1 - u[1]), root * u[1]};
}
inline double uniform_triangle_pdf(const Point<2>& b) {
    return b[0] >= 0 && b[1] >= 0 && b[0] + b[1] <= 1 ? 2 : 0;
}
inline Point<2> invert_uniform_triangle(const Point<2>& b) {
    const double root = b[0] + b[1];
    return {root * root, root > 0 ? b[1] / root : 0};
}

}  // namespace plumb
