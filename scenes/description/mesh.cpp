#include "scenes/description/mesh.h"

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

std::array<float, 3> rounded(Vec3 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

Vec3 widened(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

void turn_triangles(Mesh& mesh) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

/// A face from its lower left corner along two edges.
void add_quad(Mesh& mesh, Vec3 corner, Vec3 along_u, Vec3 along_v) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& [u, v] : {std::pair{0.f, 0.f}, {1.f, 0.f}, {1.f, 1.f}, {0.f, 1.f}}) {
        mesh.positions.push_back(rounded(corner + along_u * u + along_v * v));
        mesh.uvs.push_back({u, v});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

}  // namespace

bool Mesh::turned_by_normals(std::uint32_t triangle) const {
    if (normals.empty()) return false;
    const auto [a, b, c] = corners(triangle);
    Vec3 sum;
    for (const std::uint32_t vertex : triangles[triangle]) sum += widened(normals[vertex]);
    return dot(cross(b - a, c - a), sum) < 0;
}

Mesh transformed(Mesh mesh, const Transform& transform) {
    for (auto& p : mesh.positions) p = rounded(transform.point(widened(p)));
    for (auto& n : mesh.normals) {
        const Vec3 normal = transform.normal(widened(n));
        // Files have zero normals: who shades takes the triangle's there.
        n = length_squared(normal) > 0 ? rounded(normalize(normal)) : std::array{0.f, 0.f, 0.f};
    }
    if (transform.determinant() < 0) turn_triangles(mesh);
    return mesh;
}

void add_smooth_normals(Mesh& mesh) {
    std::vector<Vec3> sums(mesh.positions.size());
    for (const auto& triangle : mesh.triangles) {
        const std::array<Vec3, 3> p{mesh.position(triangle[0]), mesh.position(triangle[1]), mesh.position(triangle[2])};
        const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
        if (!(length_squared(normal) > 0)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
            sums[triangle[i]] += normalize(normal) * std::atan2(length(cross(a, b)), dot(a, b));
        }
    }
    mesh.normals.clear();
    for (const Vec3 sum : sums) {
        mesh.normals.push_back(length_squared(sum) > 0 ? rounded(normalize(sum)) : std::array{0.f, 0.f, 1.f});
    }
}

void flip_normals(Mesh& mesh) {
    turn_triangles(mesh);
    for (auto& n : mesh.normals) n = {-n[0], -n[1], -n[2]};
}

Mesh rectangle_mesh() {
    Mesh mesh;
    add_quad(mesh, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    return mesh;
}

Mesh cube_mesh() {
    Mesh mesh;
    add_quad(mesh, {-1, -1, 1}, {2, 0, 0}, {0, 2, 0});
    add_quad(mesh, {1, -1, -1}, {-2, 0, 0}, {0, 2, 0});
    add_quad(mesh, {1, -1, 1}, {0, 0, -2}, {0, 2, 0});
    add_quad(mesh, {-1, -1, -1}, {0, 0, 2}, {0, 2, 0});
    add_quad(mesh, {-1, 1, 1}, {2, 0, 0}, {0, 0, -2});
    add_quad(mesh, {-1, -1, -1}, {2, 0, 0}, {0, 0, 2});
    return mesh;
}

}  // namespace plumb
