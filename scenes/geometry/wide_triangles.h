#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scenes/geometry/shape.h"

namespace plumb {

// A plane test in floats errs by some 2^-21 of the triangle's size (Facet), which is nothing to a triangle among its
// like, and a house to one that is a ground with a horizon. So triangles are met in doubles, as spheres and disks are,
// where floats would take more than 2^-10 of the smallest thing of the scene: rays leave them, and find a place on
// them, as near as the floats of that place allow, however far they go on.

/// Lets rays meet in doubles the triangles that are wide beside the smallest of the shapes: sets what margin their
/// meshes allow. The size of a shape is its longest extent along an axis; of a mesh, the longest side of its smallest
/// triangle.
void meet_wide_triangles_in_doubles(std::span<description::Shape> shapes);

/// The numbers of the mesh's triangles that rays meet in doubles.
std::vector<std::uint32_t> wide_triangles(const Mesh& mesh);

/// Where a ray meets a triangle: at origin + t direction, which is v0 (1−u−v) + v1 u + v2 v.
struct TriangleHit {
    double t, u, v;
};

/// The hit of the ray with a triangle within (0, t_max], in doubles for the ray as it stands. A ray through a side that
/// two triangles have in common meets one of them at least [Woop, Benthin & Wald 2013].
std::optional<TriangleHit> meet_triangle(const std::array<Vec3, 3>& corners, const Ray& ray);

}  // namespace plumb
