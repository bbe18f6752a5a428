#include "scenes/geometry/wide_triangles.h"

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

constexpr double largest_share = 0x1p-10;  // of the smallest thing, that a ray may be lifted off a triangle

double size_of(const Mesh& mesh) {
    double smallest = HUGE_VAL;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Facet facet(mesh.corners(i));
        if (facet.twice_area > 0) smallest = std::min(smallest, facet.longest);
    }
    return smallest;
}

double size_of(const auto& shape) {
    const auto [low, high] = shape.bounds();
    const Vec3 extent = high - low;
    return std::max({extent.x, extent.y, extent.z});
}

}  // namespace

void meet_wide_triangles_in_doubles(std::span<description::Shape> shapes) {
    double smallest = HUGE_VAL;
    for (const description::Shape& shape : shapes)
        smallest =
            std::min(smallest, std::visit([](const auto& geometry) { return size_of(geometry); }, shape.geometry));
    for (description::Shape& shape : shapes)
        if (Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) mesh->largest_margin = largest_share * smallest;
}

std::vector<std::uint32_t> wide_triangles(const Mesh& mesh) {
    std::vector<std::uint32_t> wide;
    if (mesh.largest_margin == HUGE_VAL) return wide;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        if (const Facet facet(mesh.corners(i), mesh.largest_margin); facet.wide && facet.twice_area > 0)
            wide.push_back(i);
    return wide;
}

std::optional<TriangleHit> meet_triangle(const std::array<Vec3, 3>& corners, const Ray& ray) {
    const Vec3 a = corners[0] - ray.origin, b = corners[1] - ray.origin, c = corners[2] - ray.origin;
    // Volumes of the ray with each side. Two triangles compute that of a common side from the same numbers, and its
    // sign turns with the side: no ray passes between them.
    const double of_a = dot(cross(c, b), ray.direction), of_b = dot(cross(a, c), ray.direction),
                 of_c = dot(cross(b, a), ray.direction);
    if (std::min({of_a, of_b, of_c}) < 0 && std::max({of_a, of_b, of_c}) > 0) return {};
    const double volume = of_a + of_b + of_c;
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double t = dot(a, normal) / dot(ray.direction, normal);
    if (!(t > 0 && t <= ray.t_max) || volume == 0) return {};  // NaN too: a ray within the plane
    return TriangleHit{t, of_b / volume, of_c / volume};
}

}  // namespace plumb
