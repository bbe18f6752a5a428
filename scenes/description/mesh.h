#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scenes/description/transform.h"

namespace plumb {

/// Triangles whose vertices are floats: these floats are the geometry, for Embree and for everything that is computed
/// from them in double. A triangle's outside is the side from which its vertices turn counterclockwise, unless its
/// normals say otherwise.
struct Mesh {
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<float, 3>> normals;  ///< unit shading normals, one a vertex, or empty
    std::vector<std::array<float, 2>> uvs;      ///< one a vertex, or empty; v grows downwards in a bitmap
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// The largest margin with which rays may meet and leave a triangle in floats (Facet); they meet any other in
    /// doubles. A scene sets it, by the smallest of its things (scenes/geometry/wide_triangles.h).
    double largest_margin = HUGE_VAL;

    [[nodiscard]] Vec3 position(std::uint32_t vertex) const {
        const auto& p = positions[vertex];
        return {p[0], p[1], p[2]};
    }
    /// The triangle's three vertices, in its order.
    [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t triangle) const {
        const auto& [i, j, k] = triangles[triangle];
        return {position(i), position(j), position(k)};
    }
    /// Whether the vertices' normals point, in sum, to the side from which the vertices turn clockwise: then that side
    /// is the triangle's outside.
    [[nodiscard]] bool turned_by_normals(std::uint32_t triangle) const;
};

/// The mesh in another space, each float rounded once. A mirroring transform turns the vertices' order, so that the
/// outside stays outside.
Mesh transformed(Mesh mesh, const Transform& transform);

/// Gives the mesh shading normals: means of the adjacent triangles' normals, weighted by their angles [Thürmer &
/// Wüthrich 1998]. A vertex without any proper triangle gets (0, 0, 1).
void add_smooth_normals(Mesh& mesh);

/// Turns the inside out: the order of the triangles' vertices and the shading normals.
void flip_normals(Mesh& mesh);

/// The square [-1,1]² at z = 0, facing +z, with uv (0,0) at (-1,-1).
Mesh rectangle_mesh();
/// The cube [-1,1]³, facing outwards, with uv [0,1]² on each face.
Mesh cube_mesh();

}  // namespace plumb
