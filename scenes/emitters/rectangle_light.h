#pragma once

#include "core/error.h"
#include "scenes/emitters/surface.h"

namespace plumb {

/// A rectangle or parallelogram corner + s·edge_1 + t·edge_2, s and t in [0,1], that shines to the side of
/// edge_1 × edge_2; sampled uniformly per area.
class RectangleLight {
public:
    RectangleLight(Vec3 corner, Vec3 edge_1, Vec3 edge_2, const Spectrum& radiance)
        : corner_(corner),
          edge_1_(edge_1),
          edge_2_(edge_2),
          halves_{Facet({corner, corner + edge_1, corner + edge_1 + edge_2}),
                  Facet({corner, corner + edge_1 + edge_2, corner + edge_2})},
          radiance_(radiance) {
        const Vec3 product = cross(edge_1, edge_2);
        area_ = length(product);
        if (!(area_ > 0 && std::isfinite(area_)))
            throw Error(fmt::format("rectangle light of area {}: it must be positive and finite", area_));
        normal_ = product / area_;
    }

    [[nodiscard]] std::optional<EmitterSample> sample(Vec3 from, const Point<2>& u) const {
        return sample_towards(from, at(u), radiance_, pdf_area());
    }
    [[nodiscard]] std::optional<EmitterHit> hit(Vec3 from, Vec3 direction) const {
        const auto plane = meet_plane(from, direction, corner_, normal_);
        if (!plane) return {};
        const Vec3 p = from + direction * plane->distance - corner_;
        const double s = dot(cross(p, edge_2_), normal_) / area_, t = dot(cross(edge_1_, p), normal_) / area_;
        if (!(0 <= s && s <= 1 && 0 <= t && t <= 1)) return {};
        return EmitterHit{plane->distance, radiance_, per_steradian(pdf_area(), plane->distance, plane->cos_at_light)};
    }
    [[nodiscard]] EmittedRay sample_ray(const Ball&, const Point<2>& u, const Point<2>& v) const {
        return send_from(at(u), radiance_, pdf_area(), v);
    }
    [[nodiscard]] EmittedRayPdf ray_pdf(const Ball&, Vec3 normal, Vec3 direction) const {
        return ray_pdf_from(pdf_area(), normal, direction);
    }
    [[nodiscard]] double pdf_area() const { return 1 / area_; }
    [[nodiscard]] Spectrum power(double) const { return lambertian_power(radiance_, area_); }

private:
    [[nodiscard]] SurfacePoint at(const Point<2>& u) const {
        const auto& [s, t] = u;
        return s >= t ? triangle_point(halves_[0], s - t, t) : triangle_point(halves_[1], s, t - s);
    }

    Vec3 corner_, edge_1_, edge_2_, normal_;
    std::array<Facet, 2> halves_;  // as rays meet it: two triangles, whose common side leaves the corner
    Spectrum radiance_;
    double area_;
};
static_assert(EmitterModel<RectangleLight>);

}  // namespace plumb
