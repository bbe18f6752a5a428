#pragma once

#include <array>

#include "scenes/description/models.h"
#include "scenes/geometry/box.h"
#include "scenes/geometry/shape_hit.h"

namespace plumb::description {

/// A sphere in world space.
struct Sphere {
    Vec3 center;
    double radius = 1;
    bool flip_normals = false;  ///< the outside is inside
    Transform to_world;         ///< of the unit sphere: carries the poles of its uv

    static constexpr std::array plugins{Plugin{"sphere", "a sphere, not of triangles"}};
    static Sphere load(Properties& properties);

    [[nodiscard]] std::optional<double> intersect(const Ray& ray) const;
    /// The surface where the ray meets the sphere; uv is azimuth and polar angle, scaled to [0, 1], as in Mitsuba.
    [[nodiscard]] Hit hit(const Ray& ray, double t) const;
    [[nodiscard]] Box bounds() const;
};
static_assert(AnalyticShape<Sphere>);

}  // namespace plumb::description
