#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>

#include "scenes/description/mesh.h"
#include "scenes/geometry/box.h"
#include "scenes/geometry/surface_point.h"

namespace plumb {

/// The surface where a ray meets the scene.
struct Hit {
    std::uint32_t shape = 0;              ///< index into the shapes
    std::uint32_t primitive = 0;          ///< triangle of a mesh, else 0
    double t = 0;                         ///< along the ray's direction
    std::array<double, 2> barycentric{};  ///< (u, v) of a triangle: v0 (1−u−v) + v1 u + v2 v
    SurfacePoint point;                   ///< its normal points outside
    Vec3 shading_normal;                  ///< unit, interpolated where the mesh has normals
    std::array<double, 2> uv{};           ///< surface parameters for textures
};

/// Sets the hit to the surface where a ray met a mesh; `shape` is left at 0. The parameters are Mitsuba's: the mesh's
/// uvs or else (u, v). All of it is written in place: a hit is long, and one is made for every ray.
void set_mesh_hit(Hit& hit, const Mesh& mesh, std::uint32_t triangle, double u, double v);

/// The azimuth of (x, y) over 2π, in [0, 1).
double turn(double x, double y);

/// What a shape without triangles says of itself; a mesh is asked for its triangles.
template <class Shape>
concept AnalyticShape = requires(const Shape& shape, const Ray& ray, double t) {
    /// The smallest t in (0, t_max] at which the ray meets the shape, in double, for the ray as it stands.
    { shape.intersect(ray) } -> std::same_as<std::optional<double>>;
    /// The surface where the ray met it; `shape` is left at 0.
    { shape.hit(ray, t) } -> std::same_as<Hit>;
    { shape.bounds() } -> std::same_as<Box>;
};

}  // namespace plumb
