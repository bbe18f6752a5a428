#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "scenes/description/description.h"
#include "scenes/geometry/surface_point.h"

namespace plumb {

/// Where a ray meets the scene.
struct Hit {
    std::uint32_t shape = 0;              ///< index into the shapes
    std::uint32_t primitive = 0;          ///< triangle of a mesh, else 0
    double t = 0;                         ///< along the ray's direction
    std::array<double, 2> barycentric{};  ///< (u, v) of a triangle: v0 (1−u−v) + v1 u + v2 v
    SurfacePoint point;                   ///< its normal points outside
    Vec3 shading_normal;                  ///< unit, interpolated where the mesh has normals
    std::array<double, 2> uv{};           ///< surface parameters for textures
};

/// The smallest t in (0, t_max] at which the ray meets the shape, in double, for the ray as it stands.
std::optional<double> intersect(const description::Sphere& sphere, const Ray& ray);
std::optional<double> intersect(const description::Disk& disk, const Ray& ray);

/// The surface where a ray met it; `shape` is left at 0. Parameters as Mitsuba's: of a mesh its uvs or else (u, v), of
/// a sphere (azimuth, polar angle) and of a disk (radius, azimuth), scaled to [0, 1]. All of it is written in place: a
/// hit is long, and is made for every ray.
void set_mesh_hit(Hit& hit, const Mesh& mesh, std::uint32_t triangle, double u, double v);
Hit sphere_hit(const description::Sphere& sphere, const Ray& ray, double t);
Hit disk_hit(const description::Disk& disk, const Ray& ray, double t);

}  // namespace plumb
