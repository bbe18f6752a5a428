#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scenes/description/transform.h"

namespace plumb {

/// Triangles in single precision: the floats are the geometry, for Embree as for everything computed from them in
/// double. A triangle's outside is where its vertices turn counterclockwise, unless its normals say otherwise.
struct Mesh {
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<float, 3>> normals;  ///< unit shading normals, one a vertex, or empty
    std::vector<std::array<float, 2>> uvs;      ///< one a vertex, or empty; v grows downwards in a bitmap
    std::vector<std::array<std::uint32_t, 3>> triangles;

    [[nodiscard]] Vec3 position(std::uint32_t vertex) const {
        const auto& p = positions[vertex];
        return {p[0], p[1], p[2]};
    }
    [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t triangle) const {
        const auto& [i, j, k] = triangles[triangle];
        return {position(i), position(j), position(k)};
    }
    /// Whether the vertices' normals point, in sum, to the side from which the vertices turn clockwise: then that side
    /// is the triangle's outside.
    [[nodiscard]] bool turned_by_normals(std::uint32_t triangle) const;
};

/// The mesh in another space, rounded once. A mirroring transform turns the vertices' order, so that outside stays.
Mesh transformed(Mesh mesh, const Transform& transform);

/// Shading normals as means of the adjacent triangles' normals weighted by their angles [Thürmer & Wüthrich 1998];
/// a vertex without any proper triangle gets (0, 0, 1).
void add_smooth_normals(Mesh& mesh);

/// The inside turned out: triangles and shading normals.
void flip_normals(Mesh& mesh);

/// [-1,1]² at z = 0, facing +z, uv (0,0) at (-1,-1).
Mesh rectangle_mesh();
/// [-1,1]³ facing outwards, uv [0,1]² on each face.
Mesh cube_mesh();

}  // namespace plumb
