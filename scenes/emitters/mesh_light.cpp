#include "scenes/emitters/mesh_light.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "estimators/densities/warps.h"

namespace plumb {

namespace {

std::vector<double> areas(const std::vector<Triangle>& triangles) {
    std::vector<double> areas;
    double sum = 0;
    for (const auto& [a, b, c] : triangles) sum += areas.emplace_back(length(cross(b - a, c - a)) / 2);
    if (!(sum > 0 && std::isfinite(sum)))
        throw Error(fmt::format("mesh light of {} triangles and area {}: the area must be positive and finite",
                                triangles.size(), sum));
    return areas;
}

std::optional<PlaneHit> meet_one(const Triangle& t, Vec3 from, Vec3 direction) {
    const Vec3 product = cross(t.b - t.a, t.c - t.a);
    const double twice_area = length(product);
    if (!(twice_area > 0)) return {};
    const Vec3 normal = product / twice_area;
    const auto plane = meet_plane(from, direction, t.a, normal);
    if (!plane) return {};
    const Vec3 p = from + direction * plane->distance - t.a;
    const double b1 = dot(cross(p, t.c - t.a), normal), b2 = dot(cross(t.b - t.a, p), normal);
    if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= twice_area)) return {};
    return plane;
}

}  // namespace

std::vector<Triangle> triangles_of(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        auto [a, b, c] = mesh.corners(i);
        if (mesh.turned_by_normals(i)) std::swap(b, c);
        triangles.push_back({a, b, c});
    }
    return triangles;
}

MeshSurface::MeshSurface(std::vector<Triangle> triangles, double largest_margin)
    : triangles_(std::move(triangles)), choice_(areas(triangles_)), largest_margin_(largest_margin) {
    for (const double area : areas(triangles_)) area_ += area;
}

TrianglePlace MeshSurface::place(const Point<2>& u) const {
    const double count = static_cast<double>(triangles_.size()), place = choice_.sample(u[0]) * count;
    const std::size_t i = std::min(static_cast<std::size_t>(place), triangles_.size() - 1);
    const auto [b1, b2] = sample_uniform_triangle({place - static_cast<double>(i), u[1]});
    return {i, b1, b2};
}

SurfacePoint MeshSurface::at(const Point<2>& u) const {
    const auto [i, b1, b2] = place(u);
    const auto& [a, b, c] = triangles_[i];
    return triangle_point(Facet({a, b, c}, largest_margin_), b1, b2);
}

std::optional<PlaneHit> MeshSurface::meet(Vec3 from, Vec3 direction) const {
    std::optional<PlaneHit> nearest;
    for (const Triangle& triangle : triangles_)
        if (const auto one = meet_one(triangle, from, direction);
            one && (!nearest || one->distance < nearest->distance))
            nearest = one;
    return nearest;
}

}  // namespace plumb
