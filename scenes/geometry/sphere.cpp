#include "scenes/geometry/sphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb::description {

Sphere Sphere::load(Properties& properties) {
    const Transform to_world = properties.transform("to_world");
    const Vec3 center = properties.vector("center", {0, 0, 0});
    const double radius = properties.number("radius", 1);
    const Place& place = properties.place();
    if (!(radius > 0))
        throw properties.place_of("radius").error(fmt::format("a sphere of radius {}; above 0 is accepted", radius));
    Sphere sphere{.center = to_world.point(center),
                  .radius = radius,
                  .flip_normals = properties.boolean("flip_normals", false),
                  .to_world = to_world * Transform::translate(center) * Transform::scale({radius, radius, radius})};
    const double x = length(to_world.vector({1, 0, 0})), y = length(to_world.vector({0, 1, 0})),
                 z = length(to_world.vector({0, 0, 1}));
    const Vec3 a = to_world.vector({1, 0, 0}) / x, b = to_world.vector({0, 1, 0}) / y,
               c = to_world.vector({0, 0, 1}) / z;
    const double skew = std::max({std::abs(dot(a, b)), std::abs(dot(b, c)), std::abs(dot(c, a))});
    // Matrices in files have six digits.
    if (std::abs(x - y) > 1e-4 * x || std::abs(x - z) > 1e-4 * x || skew > 1e-4) {
        throw place.error(fmt::format("a sphere scaled by {} {} {}; uniform scaling is accepted", x, y, z));
    }
    sphere.radius = radius * std::cbrt(std::abs(to_world.determinant()));
    return sphere;
}

std::optional<double> Sphere::intersect(const Ray& ray) const {
    // Without cancellation far away or close to the surface [Haines, Günther and Akenine-Möller 2019].
    const Vec3 f = ray.origin - center;
    const double a = length_squared(ray.direction), b = -dot(f, ray.direction);
    const double discriminant = radius * radius - length_squared(f + ray.direction * (b / a));
    if (!(discriminant >= 0)) return {};
    const double distance = length(f), c = (distance - radius) * (distance + radius);
    const double q = b + std::copysign(std::sqrt(a * discriminant), b);
    const double near = std::min(c / q, q / a), far = std::max(c / q, q / a);
    const double t = near > 0 ? near : far;
    if (t > 0 && t <= ray.t_max) return t;
    return {};
}

Hit Sphere::hit(const Ray& ray, double t) const {
    const Vec3 direction = normalize(ray.origin + ray.direction * t - center);
    Hit hit{.t = t, .point = sphere_point(center, radius, direction), .shading_normal = {}};
    if (flip_normals) hit.point.normal = -direction;
    hit.shading_normal = hit.point.normal;
    const Vec3 local = normalize(to_world.inverse().vector(direction));
    hit.uv = {turn(local.x, local.y), std::acos(std::clamp(local.z, -1.0, 1.0)) / std::numbers::pi};
    return hit;
}

Box Sphere::bounds() const {
    const Vec3 reach{radius, radius, radius};
    return {center - reach, center + reach};
}

}  // namespace plumb::description
