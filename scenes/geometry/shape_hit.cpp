#include "scenes/geometry/shape_hit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb {

namespace {

using description::Disk;
using description::Sphere;

Vec3 widened(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// Azimuth over 2π, in [0, 1).
double turn(double x, double y) {
    const double angle = std::atan2(y, x) / (2 * std::numbers::pi);
    return angle < 0 ? angle + 1 : angle;
}

/// Coordinates of a point of the disk's plane in its axes.
std::array<double, 2> disk_coordinates(const Disk& disk, Vec3 from_center) {
    const Vec3 n = cross(disk.axis_x, disk.axis_y);
    const double scale = 1 / length_squared(n);
    return {dot(cross(from_center, disk.axis_y), n) * scale, dot(cross(disk.axis_x, from_center), n) * scale};
}

}  // namespace

std::optional<double> intersect(const Sphere& sphere, const Ray& ray) {
    // Without cancellation far away or close to the surface [Haines, Günther & Akenine-Möller 2019].
    const Vec3 f = ray.origin - sphere.center;
    const double a = length_squared(ray.direction), b = -dot(f, ray.direction);
    const double discriminant = sphere.radius * sphere.radius - length_squared(f + ray.direction * (b / a));
    if (!(discriminant >= 0)) return {};
    const double distance = length(f), c = (distance - sphere.radius) * (distance + sphere.radius);
    const double q = b + std::copysign(std::sqrt(a * discriminant), b);
    const double near = std::min(c / q, q / a), far = std::max(c / q, q / a);
    const double t = near > 0 ? near : far;
    if (t > 0 && t <= ray.t_max) return t;
    return {};
}

std::optional<double> intersect(const Disk& disk, const Ray& ray) {
    const double t = dot(disk.center - ray.origin, disk.normal) / dot(ray.direction, disk.normal);
    if (!(t > 0 && t <= ray.t_max)) return {};  // NaN too: a ray within the plane
    const auto [x, y] = disk_coordinates(disk, ray.origin + ray.direction * t - disk.center);
    if (x * x + y * y <= 1) return t;
    return {};
}

void set_mesh_hit(Hit& hit, const Mesh& mesh, std::uint32_t triangle, double u, double v) {
    const auto& [i, j, k] = mesh.triangles[triangle];
    hit.primitive = triangle;
    hit.barycentric = {u, v};
    hit.point = triangle_point(Facet(mesh.corners(triangle)), u, v);
    hit.shading_normal = hit.point.normal;
    if (!mesh.normals.empty()) {
        if (mesh.turned_by_normals(triangle)) hit.shading_normal = hit.point.normal = -hit.point.normal;
        const Vec3 n =
            widened(mesh.normals[i]) * (1 - u - v) + widened(mesh.normals[j]) * u + widened(mesh.normals[k]) * v;
        if (length_squared(n) > 0) hit.shading_normal = normalize(n);
    }
    hit.uv = {u, v};
    if (mesh.uvs.empty()) return;
    for (std::size_t a = 0; a < 2; ++a)
        hit.uv[a] = mesh.uvs[i][a] * (1 - u - v) + mesh.uvs[j][a] * u + mesh.uvs[k][a] * v;
}

Hit sphere_hit(const Sphere& sphere, const Ray& ray, double t) {
    const Vec3 direction = normalize(ray.origin + ray.direction * t - sphere.center);
    Hit hit{.t = t, .point = sphere_point(sphere.center, sphere.radius, direction), .shading_normal = {}};
    if (sphere.flip_normals) hit.point.normal = -direction;
    hit.shading_normal = hit.point.normal;
    const Vec3 local = normalize(sphere.to_world.inverse().vector(direction));
    hit.uv = {turn(local.x, local.y), std::acos(std::clamp(local.z, -1.0, 1.0)) / std::numbers::pi};
    return hit;
}

Hit disk_hit(const Disk& disk, const Ray& ray, double t) {
    const Vec3 met = ray.origin + ray.direction * t;
    const Vec3 position = met - disk.normal * dot(met - disk.center, disk.normal);
    const auto [x, y] = disk_coordinates(disk, position - disk.center);
    return {.t = t,
            .point = disk_point(position, disk.normal),
            .shading_normal = disk.normal,
            .uv = {std::hypot(x, y), turn(x, y)}};
}

}  // namespace plumb
