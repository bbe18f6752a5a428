#pragma once

#include <array>
#include <cmath>

#include "core/vec3.h"
#include "scenes/geometry/ray.h"

namespace plumb {

// How a ray leaves a surface. Embree traces in single precision, so an origin is rounded to floats: by at most
// r = 2^-24 |p| an axis. Three displacements, all from this bound and none from an epsilon, keep a rounded origin on
// the side where it belongs:
//   along the normal by dot(|n|, r), which undoes the worst rounding, and by `margin`, which bounds the error of the
//   plane test for an origin that near: Embree's, in floats, or ours, in doubles, for triangles that are wide beside
//   what stands on them (scenes/geometry/wide_triangles.h);
//   along a triangle, away from its edges by 2 |r|, so that rounding does not carry the origin through a neighbour that
//   meets it at an edge, at 53° or more (a triangle too small for that is left from the centre of its inscribed
//   circle).
// So an origin is lifted off its surface by less than 2 |r| + 2 margin: at 2^12 sizes from the world's origin, by less
// than 1e-3 sizes. Surfaces nearer together than that, floats cannot tell apart.

/// A point of a surface, in world space, with what is needed to leave it.
struct SurfacePoint {
    Vec3 position;
    Vec3 normal;        ///< unit, geometric, towards the outside
    Vec3 inset;         ///< the position, moved within the surface away from its edges: where rays start
    double margin = 0;  ///< by which a start must be off the surface along the normal, beyond the rounding of floats
};

/// Half a unit in the last place of a float, at most, for each coordinate.
Vec3 float_rounding(Vec3 p);

/// A proper triangle with the numbers that all its points share.
struct Facet {
    std::array<Vec3, 3> vertices;
    Vec3 normal;                          ///< unit, by the vertices' order
    double twice_area, longest;           ///< longest: its longest side
    std::array<double, 3> sides_squared;  ///< of the side that faces each vertex
    double margin;                        ///< of its points
    bool wide;                            ///< whether rays meet it in doubles

    /// The margin is that of a plane test in floats or, where this would be larger than `largest_margin`, in doubles.
    explicit Facet(const std::array<Vec3, 3>& corners, double largest_margin = HUGE_VAL);
};

/// The point v0 (1−u−v) + v1 u + v2 v of the triangle.
SurfacePoint triangle_point(const Facet& facet, double u, double v);
/// The point of the sphere in a unit direction from its centre; its normal is that direction.
SurfacePoint sphere_point(Vec3 center, double radius, Vec3 direction);
/// A point of a disk with this normal that reaches this far from its centre.
SurfacePoint disk_point(Vec3 position, Vec3 normal, double radius);

/// The floats, as doubles, from which a ray towards `direction` leaves the point: on the side of its normal to which
/// the direction points. `extra` is a further uncertainty along each axis, which the far end of a segment has.
Vec3 ray_origin(const SurfacePoint& from, Vec3 direction, Vec3 extra = {});

// The numbers of the rays below are floats' values, as Embree will see them.

/// A ray from a point of a surface towards a direction of any length.
Ray leave(const SurfacePoint& from, Vec3 direction);
/// The open segment between two points of surfaces: neither surface lies on it where they see each other.
Ray connect(const SurfacePoint& from, const SurfacePoint& to);
/// The open segment from a point of a surface to a point in space, which is on no surface.
Ray connect_to_space(const SurfacePoint& from, Vec3 to);
/// A ray from anywhere in space, as a camera sends it, rounded to floats.
Ray rounded_ray(Vec3 origin, Vec3 direction, double t_max = HUGE_VAL);

}  // namespace plumb
