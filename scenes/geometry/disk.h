#pragma once

#include <array>

#include "scenes/description/models.h"
#include "scenes/geometry/box.h"
#include "scenes/geometry/shape_hit.h"

namespace plumb::description {

/// The points center + axis_x·x + axis_y·y with x² + y² ≤ 1, in world space.
struct Disk {
    Vec3 center, axis_x{1, 0, 0}, axis_y{0, 1, 0};
    Vec3 normal{0, 0, 1};  ///< unit

    static constexpr std::array plugins{Plugin{"disk", "the unit disk at z = 0"}};
    static Disk load(Properties& properties);

    [[nodiscard]] std::optional<double> intersect(const Ray& ray) const;
    /// The surface where the ray meets the disk; uv is radius and azimuth, scaled to [0, 1], as in Mitsuba.
    [[nodiscard]] Hit hit(const Ray& ray, double t) const;
    /// The box around the parallelogram that holds the disk.
    [[nodiscard]] Box bounds() const;
};
static_assert(AnalyticShape<Disk>);

}  // namespace plumb::description
