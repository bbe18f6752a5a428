#include "scenes/geometry/shape_hit.h"

#include <cmath>
#include <numbers>

namespace plumb {

namespace {

Vec3 widened(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

}  // namespace

double turn(double x, double y) {
    const double angle = std::atan2(y, x) / (2 * std::numbers::pi);
    return angle < 0 ? angle + 1 : angle;
}

void set_mesh_hit(Hit& hit, const Mesh& mesh, std::uint32_t triangle, double u, double v) {
    const auto& [i, j, k] = mesh.triangles[triangle];
    hit.primitive = triangle;
    hit.barycentric = {u, v};
    hit.point = triangle_point(Facet(mesh.corners(triangle), mesh.largest_margin), u, v);
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

}  // namespace plumb
