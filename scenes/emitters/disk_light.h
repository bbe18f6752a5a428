#pragma once

#include "core/error.h"
#include "estimators/densities/warps.h"
#include "scenes/emitters/area_light.h"
#include "scenes/geometry/disk.h"

namespace plumb {

/// A disk, seen from the side of its unit normal.
class DiskSurface {
public:
    DiskSurface(Vec3 centre, Vec3 normal, double radius) : centre_(centre), frame_(normal), radius_(radius) {
        if (!(radius > 0 && std::isfinite(radius)))
            throw Error(fmt::format("disk light of radius {}: it must be positive and finite", radius));
    }

    [[nodiscard]] double area() const { return pi * radius_ * radius_; }
    [[nodiscard]] SurfacePoint at(const Point<2>& u) const {
        const Point<2> p = sample_concentric_disk(u);
        return disk_point(centre_ + frame_.to_world({radius_ * p[0], radius_ * p[1], 0}), frame_.z, radius_);
    }
    [[nodiscard]] std::optional<PlaneHit> meet(Vec3 from, Vec3 direction) const {
        const auto plane = meet_plane(from, direction, centre_, frame_.z);
        if (!plane) return {};
        if (length_squared(from + direction * plane->distance - centre_) > radius_ * radius_) return {};
        return plane;
    }

private:
    Vec3 centre_;
    Frame frame_;
    double radius_;
};

/// A disk that shines to the side of its unit normal.
class DiskLight : public AreaLight<DiskSurface> {
public:
    DiskLight(Vec3 centre, Vec3 normal, double radius, const Spectrum& radiance)
        : AreaLight({centre, normal, radius}, radiance) {}
    /// The light that a disk is. Throws Error where the disk is an ellipse.
    static DiskLight of(const description::Disk& disk, const Spectrum& radiance);
};
static_assert(LightModel<DiskLight>);

}  // namespace plumb
