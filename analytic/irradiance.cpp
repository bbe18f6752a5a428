#include "analytic/irradiance.h"

#include <fmt/format.h>

#include <numbers>

#include "core/error.h"

namespace plumb {

namespace {

using std::numbers::pi;

/// The part of a polygon above the plane through the origin with normal n [Sutherland & Hodgman 1974].
std::vector<Vec3> above_horizon(Vec3 n, const std::vector<Vec3>& corners) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = corners[i], b = corners[(i + 1) % corners.size()];
        const double height_a = dot(n, a), height_b = dot(n, b);
        if (height_a >= 0) kept.push_back(a);
        if ((height_a >= 0) != (height_b >= 0)) kept.push_back(a + (b - a) * (height_a / (height_a - height_b)));
    }
    return kept;
}

}  // namespace

double polygon_irradiance(Vec3 p, Vec3 n, const std::vector<Vec3>& corners) {
    if (corners.size() < 3) throw Error(fmt::format("polygon of {} corners: at least 3 are needed", corners.size()));
    std::vector<Vec3> seen;
    for (const Vec3 corner : corners) seen.push_back(corner - p);
    seen = above_horizon(n, seen);
    double sum = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Vec3 a = seen[i], b = seen[(i + 1) % seen.size()], product = cross(a, b);
        const double sine = length(product);
        if (sine > 0) sum += std::atan2(sine, dot(a, b)) * dot(n, product) / sine;
    }
    // Counter-clockwise as seen from the shining side is clockwise around the direction of sight.
    return std::max(0.0, -sum / 2);
}

double sphere_irradiance(Vec3 p, Vec3 n, Vec3 centre, double radius) {
    const Vec3 way = centre - p;
    const double d = length(way), sin = radius / d;
    if (!(d > radius))
        throw Error(fmt::format("sphere irradiance at {} radii from the centre: more than 1 is needed", 1 / sin));
    const double cos_normal = dot(n, way) / d, sin_normal = length(cross(n, way)) / d;
    // The whole cap above the horizon, or none of it.
    if (cos_normal >= sin) return pi * sin * sin * cos_normal;
    if (cos_normal <= -sin) return 0;
    // Nusselt: the area of the ellipse (semi-axes sin and sin·cos_normal) on the horizon's side of its chord, plus the
    // area of the unit circle's segment beyond the chord.
    const double cotangent = std::sqrt((d - radius) * (d + radius)) / radius;
    const double y = -cotangent * cos_normal / sin_normal, root = std::sqrt((1 - y) * (1 + y));
    return sin * sin * (cos_normal * std::acos(y) - cotangent * sin_normal * root) +
           std::atan(sin_normal * root / cotangent);
}

/// Let a be the distance of p from the disk's axis, h its height over the disk's plane, s the radius. With
/// r(t) = (a + s cos t, s sin t, h) Stokes gives the vector ½ ∮ r × dr / |r|², and D = a² + h² + s²,
/// W = √(D² − 4a²s²), ∮ dt/|r|² = 2π/W, ∮ cos t dt/|r|² = (π/as)(1 − D/W) give
///   towards the plane: (π/2)(1 − (a² + h² − s²)/W),    towards the axis: (πh/2a)(D/W − 1) = 2πhas²/(W(D + W)).
double disk_irradiance(Vec3 p, Vec3 n, Vec3 centre, Vec3 normal, double radius) {
    const Vec3 way = centre - p;
    const double h = -dot(way, normal);
    if (!(h > 0)) throw Error(fmt::format("disk irradiance at height {} over its plane: it must be positive", h));
    const double tilt = radius * length(cross(n, normal));
    if (dot(n, way) < tilt) throw Error("disk irradiance with a disk that crosses the horizon: no closed form");
    const Vec3 aside = way + normal * h;
    const double a = length(aside), s = radius, D = a * a + h * h + s * s, W = std::sqrt(D * D - 4 * a * a * s * s);
    const double rest = a * a + h * h - s * s;
    // 1 − rest/W without cancellation: W² − rest² = 4s²h².
    const double down = rest > 0 ? 2 * pi * s * s * h * h / (W * (W + rest)) : pi / 2 * (1 - rest / W);
    return down * -dot(n, normal) + 2 * pi * h * s * s / (W * (D + W)) * dot(n, aside);
}

double parallel_rectangles_form_factor(double a, double b, double c) {
    const double x = a / c, y = b / c, x1 = std::sqrt(1 + x * x), y1 = std::sqrt(1 + y * y);
    return 2 / (pi * x * y) *
           (std::log(x1 * y1 / std::sqrt(1 + x * x + y * y)) + x * y1 * std::atan(x / y1) + y * x1 * std::atan(y / x1) -
            x * std::atan(x) - y * std::atan(y));
}

double perpendicular_rectangles_form_factor(double l, double width, double height) {
    const double w = width / l, h = height / l, w2 = w * w, h2 = h * h, both = std::sqrt(w2 + h2);
    const double logs = std::log((1 + w2) * (1 + h2) / (1 + w2 + h2)) +
                        w2 * std::log(w2 * (1 + w2 + h2) / ((1 + w2) * (w2 + h2))) +
                        h2 * std::log(h2 * (1 + h2 + w2) / ((1 + h2) * (h2 + w2)));
    return (w * std::atan(1 / w) + h * std::atan(1 / h) - both * std::atan(1 / both) + logs / 4) / (pi * w);
}

double circle_of_confusion(double lens_radius, double focus, double depth) {
    return lens_radius * std::abs(depth - focus) / depth;
}

}  // namespace plumb
