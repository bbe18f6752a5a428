#include "scenes/geometry/disk.h"

#include <algorithm>
#include <cmath>

namespace plumb::description {

namespace {

/// Coordinates of a point of the disk's plane in its axes.
std::array<double, 2> disk_coordinates(const Disk& disk, Vec3 from_center) {
    const Vec3 n = cross(disk.axis_x, disk.axis_y);
    const double scale = 1 / length_squared(n);
    return {dot(cross(from_center, disk.axis_y), n) * scale, dot(cross(disk.axis_x, from_center), n) * scale};
}

}  // namespace

Disk Disk::load(Properties& properties) {
    const Transform to_world = properties.transform("to_world");
    const double side = properties.boolean("flip_normals", false) ? -1 : 1;
    return {.center = to_world.point({}),
            .axis_x = to_world.vector({1, 0, 0}),
            .axis_y = to_world.vector({0, 1, 0}),
            .normal = normalize(to_world.normal({0, 0, side}))};
}

std::optional<double> Disk::intersect(const Ray& ray) const {
    const double t = dot(center - ray.origin, normal) / dot(ray.direction, normal);
    if (!(t > 0 && t <= ray.t_max)) return {};  // NaN too: a ray within the plane
    const auto [x, y] = disk_coordinates(*this, ray.origin + ray.direction * t - center);
    if (x * x + y * y <= 1) return t;
    return {};
}

Hit Disk::hit(const Ray& ray, double t) const {
    const Vec3 met = ray.origin + ray.direction * t;
    const Vec3 position = met - normal * dot(met - center, normal);
    const auto [x, y] = disk_coordinates(*this, position - center);
    return {.t = t,
            .point = disk_point(position, normal, std::max(length(axis_x), length(axis_y))),
            .shading_normal = normal,
            .uv = {std::hypot(x, y), turn(x, y)}};
}

Box Disk::bounds() const {
    Box box;
    for (const double x : {-1., 1.})
        for (const double y : {-1., 1.}) box.add(center + axis_x * x + axis_y * y);
    return box;
}

}  // namespace plumb::description
