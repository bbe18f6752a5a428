#include "scenes/geometry/surface_point.h"

#include <algorithm>
#include <cmath>

#include "scenes/geometry/rounding.h"

namespace plumb {

namespace {

Vec3 absolute(Vec3 p) {
    return {std::abs(p.x), std::abs(p.y), std::abs(p.z)};
}

/// Barycentric coordinates at least `floor` each: the part above the floors shrinks.
std::array<double, 3> raised(const std::array<double, 3>& b, const std::array<double, 3>& floor) {
    const double sum = floor[0] + floor[1] + floor[2];
    std::array<double, 3> result;
    if (sum >= 1) {
        for (std::size_t i = 0; i < 3; ++i) result[i] = floor[i] / sum;  // floors go as the sides: the incentre
        return result;
    }
    double above = 0;
    for (std::size_t i = 0; i < 3; ++i) above += std::max(0.0, b[i] - floor[i]);
    for (std::size_t i = 0; i < 3; ++i) result[i] = floor[i] + std::max(0.0, b[i] - floor[i]) * (1 - sum) / above;
    return result;
}

}  // namespace

Vec3 float_rounding(Vec3 p) {
    // 2^-24 |p|, a little more for what is added to p before it is rounded, and half the smallest subnormal.
    return absolute(p) * (0x1p-24 * (1 + 0x1p-10)) + Vec3{0x1p-150, 0x1p-150, 0x1p-150};
}

Facet::Facet(const std::array<Vec3, 3>& corners, double largest_margin) : vertices(corners) {
    const auto& [a, b, c] = vertices;
    const Vec3 product = cross(b - a, c - a);
    twice_area = length(product);
    normal = product / twice_area;
    sides_squared = {length_squared(c - b), length_squared(c - a), length_squared(b - a)};
    longest = std::sqrt(std::max({sides_squared[0], sides_squared[1], sides_squared[2]}));
    // Embree's normal is a cross product of edges in floats, wrong by a few 2^-24 longest²; a plane test multiplies it
    // by a distance within the triangle. Doubles do the same with 2^-53, and what they compute lies 2^-52 longest off.
    const double slenderness = longest * longest / twice_area;
    margin = 0x1p-21 * longest * std::min(slenderness, 0x1p10);
    wide = margin > largest_margin;
    if (wide) margin = 0x1p-49 * longest * slenderness;
}

SurfacePoint triangle_point(const Facet& facet, double u, double v) {
    const auto at = [&](double p, double q, double r) {
        return facet.vertices[0] * p + facet.vertices[1] * q + facet.vertices[2] * r;
    };
    // Embree hands out barycentric coordinates a rounding outside the triangle.
    u = std::clamp(u, 0.0, 1.0);
    v = std::clamp(v, 0.0, 1 - u);
    SurfacePoint point{at(1 - u - v, u, v), facet.normal, {}, facet.margin};
    // Twice, because going along the normal comes nearer to a neighbour at an acute angle: where two faces meet at θ,
    // cot(θ/2) times would do, so 2 serves down to θ = 53°.
    const double away = 2 * (length(float_rounding(point.position)) + facet.margin);
    // A coordinate is the distance from its edge, times side over twice the area.
    const double per_length = away / facet.twice_area;
    point.inset = point.position;
    if (std::min({1 - u - v, u, v}) >= per_length * facet.longest) return point;
    std::array<double, 3> floor;
    for (std::size_t i = 0; i < 3; ++i) floor[i] = per_length * std::sqrt(facet.sides_squared[i]);
    const std::array<double, 3> inset = raised({1 - u - v, u, v}, floor);
    point.inset = at(inset[0], inset[1], inset[2]);
    return point;
}

SurfacePoint sphere_point(Vec3 center, double radius, Vec3 direction) {
    const Vec3 position = center + direction * radius, r = float_rounding(position);
    // Rounding along the tangent leaves a sphere by its square over the radius; doubles do the rest.
    const double margin = length_squared(r) / radius + 0x1p-46 * (length(center) + radius);
    return {.position = position, .normal = direction, .inset = position, .margin = margin};
}

SurfacePoint disk_point(Vec3 position, Vec3 normal, double radius) {
    const double margin = 0x1p-46 * (length(position) + radius);
    return {.position = position, .normal = normal, .inset = position, .margin = margin};
}

Vec3 ray_origin(const SurfacePoint& from, Vec3 direction, Vec3 extra) {
    const double side = dot(from.normal, direction) < 0 ? -1 : 1;
    const double off = dot(absolute(from.normal), float_rounding(from.inset) + extra) + from.margin;
    return rounded_to_float(from.inset + from.normal * (side * off));
}

Ray leave(const SurfacePoint& from, Vec3 direction) {
    return {ray_origin(from, direction), rounded_to_float(direction), HUGE_VAL};
}

Ray connect(const SurfacePoint& from, const SurfacePoint& to) {
    const Vec3 between = to.inset - from.inset;
    const Vec3 origin = ray_origin(from, between);
    const Vec3 target = ray_origin(to, -between, float_rounding(between) * 2);
    return {origin, rounded_to_float(target - origin), 1};
}

Ray connect_to_space(const SurfacePoint& from, Vec3 to) {
    const Vec3 origin = ray_origin(from, to - from.inset);
    return {origin, rounded_to_float(to - origin), 1};
}

Ray rounded_ray(Vec3 origin, Vec3 direction, double t_max) {
    return {rounded_to_float(origin), rounded_to_float(direction), t_max};
}

}  // namespace plumb
