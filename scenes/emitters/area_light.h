#pragma once

#include <utility>

#include "scenes/emitters/surface.h"

namespace plumb {

/// A surface that shines to one side with the same radiance, sampled uniformly over its area. The surface says
///   double area() const;
///   SurfacePoint at(const Point<2>& u) const;                            uniform per area, its normal on that side;
///   std::optional<PlaneHit> meet(Vec3 from, Vec3 direction) const;       where a ray meets the shining side first.
template <class Surface>
class AreaLight {
public:
    static constexpr LightKind kind = LightKind::surface;

    AreaLight(Surface surface, const Spectrum& radiance) : surface_(std::move(surface)), radiance_(radiance) {}

    [[nodiscard]] std::optional<LightSample> sample(Vec3 from, const Point<2>& u) const {
        return sample_towards(from, surface_.at(u), radiance_, pdf_area());
    }
    [[nodiscard]] std::optional<LightHit> hit(Vec3 from, Vec3 direction) const {
        const auto met = surface_.meet(from, direction);
        if (!met) return {};
        return LightHit{met->distance, radiance_, per_steradian(pdf_area(), met->distance, met->cos_at_light)};
    }
    [[nodiscard]] EmittedRay sample_ray(const Ball&, const Point<2>& u, const Point<2>& v) const {
        return send_from(surface_.at(u), radiance_, pdf_area(), v);
    }
    [[nodiscard]] EmittedRayPdf ray_pdf(const Ball&, Vec3 normal, Vec3 direction) const {
        return ray_pdf_from(pdf_area(), normal, direction);
    }
    /// The density of sampled points, per area. A ray caster that knows where it met the light needs no more
    /// (per_steradian).
    [[nodiscard]] double pdf_area() const { return 1 / surface_.area(); }
    [[nodiscard]] Spectrum power(double) const { return lambertian_power(radiance_, surface_.area()); }
    [[nodiscard]] const Surface& surface() const { return surface_; }

private:
    Surface surface_;
    Spectrum radiance_;
};

}  // namespace plumb
