#pragma once

#include "estimators/densities/warps.h"
#include "scenes/emitters/light.h"

namespace plumb {

// All lights that are sampled by area share what follows.

/// The sample at a point of a light that shines to the side of its normal, chosen with density pdf_area.
inline std::optional<LightSample> sample_towards(Vec3 from, const SurfacePoint& point, const Spectrum& radiance,
                                                 double pdf_area) {
    const Vec3 way = point.position - from;
    const double distance = length(way);
    const double cos_at_light = -dot(point.normal, way) / distance;
    if (!(cos_at_light > 0)) return {};
    return LightSample{way / distance,       distance, radiance, per_steradian(pdf_area, distance, cos_at_light),
                       Measure::solid_angle, point};
}

/// The distance at which a ray meets the shining side of a plane, with the cosine there.
struct PlaneHit {
    double distance, cos_at_light;
};
inline std::optional<PlaneHit> meet_plane(Vec3 from, Vec3 direction, Vec3 point, Vec3 normal) {
    const double cos_at_light = -dot(normal, direction);
    if (!(cos_at_light > 0)) return {};
    const double distance = dot(normal, from - point) / cos_at_light;
    if (!(distance > 0)) return {};
    return PlaneHit{distance, cos_at_light};
}

/// A ray from a point of a light that shines to the side of its normal, chosen with density pdf_area.
inline EmittedRay send_from(const SurfacePoint& point, const Spectrum& radiance, double pdf_area, const Point<2>& u) {
    const Vec3 local = sample_cosine_hemisphere(u);
    return {point.position,
            Frame(point.normal).to_world(local),
            radiance * (pi / pdf_area),  // cosines cancel
            {pdf_area, cosine_hemisphere_pdf(local)},
            point};
}
inline EmittedRayPdf ray_pdf_from(double pdf_area, Vec3 normal, Vec3 direction) {
    return {pdf_area, cosine_hemisphere_pdf({0, 0, dot(normal, direction)})};
}

/// The flux of a one-sided surface of constant radiance: π L A.
inline Spectrum lambertian_power(const Spectrum& radiance, double area) {
    return radiance * (std::numbers::pi * area);
}

}  // namespace plumb
