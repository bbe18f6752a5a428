#pragma once

#include "core/error.h"
#include "estimators/densities/warps.h"
#include "scenes/emitters/surface.h"

namespace plumb {

/// A disk that shines to the side of its unit normal; sampled uniformly per area.
class DiskLight {
public:
    DiskLight(Vec3 centre, Vec3 normal, double radius, const Spectrum& radiance)
        : centre_(centre), frame_(normal), radius_(radius), radiance_(radiance) {
        if (!(radius > 0 && std::isfinite(radius)))
            throw Error(fmt::format("disk light of radius {}: it must be positive and finite", radius));
    }

    [[nodiscard]] std::optional<EmitterSample> sample(Vec3 from, const Point<2>& u) const {
        return sample_towards(from, at(u), radiance_, pdf_area());
    }
    [[nodiscard]] std::optional<EmitterHit> hit(Vec3 from, Vec3 direction) const {
        const auto plane = meet_plane(from, direction, centre_, frame_.z);
        if (!plane) return {};
        if (length_squared(from + direction * plane->distance - centre_) > radius_ * radius_) return {};
        return EmitterHit{plane->distance, radiance_, per_steradian(pdf_area(), plane->distance, plane->cos_at_light)};
    }
    [[nodiscard]] EmittedRay sample_ray(const Ball&, const Point<2>& u, const Point<2>& v) const {
        return send_from(at(u), radiance_, pdf_area(), v);
    }
    [[nodiscard]] EmittedRayPdf ray_pdf(const Ball&, Vec3 normal, Vec3 direction) const {
        return ray_pdf_from(pdf_area(), normal, direction);
    }
    [[nodiscard]] double pdf_area() const { return 1 / area(); }
    [[nodiscard]] Spectrum power(double) const { return lambertian_power(radiance_, area()); }

private:
    [[nodiscard]] SurfacePoint at(const Point<2>& u) const {
        const Point<2> p = sample_concentric_disk(u);
        return disk_point(centre_ + frame_.to_world({radius_ * p[0], radius_ * p[1], 0}), frame_.z);
    }
    [[nodiscard]] double area() const { return pi * radius_ * radius_; }

    Vec3 centre_;
    Frame frame_;
    double radius_;
    Spectrum radiance_;
};
static_assert(EmitterModel<DiskLight>);

}  // namespace plumb
