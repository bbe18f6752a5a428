#pragma once

#include "core/error.h"
#include "estimators/densities/warps.h"
#include "scenes/emitters/surface.h"
#include "scenes/geometry/sphere.h"

namespace plumb {

/// A sphere that shines outwards, or inwards (flipped normals). From outside, the directions to its visible cap are
/// sampled uniformly [Shirley, Wang & Zimmerman 1996]; from inside, all directions are.
class SphereLight {
public:
    static constexpr LightKind kind = LightKind::surface;
    enum class Side { outwards, inwards };

    SphereLight(Vec3 centre, double radius, const Spectrum& radiance, Side side = Side::outwards)
        : centre_(centre), radius_(radius), radiance_(radiance), side_(side) {
        if (!(radius > 0 && std::isfinite(radius)))
            throw Error(fmt::format("sphere light of radius {}: it must be positive and finite", radius));
    }

    static SphereLight of(const description::Sphere& sphere, const Spectrum& radiance) {
        return {sphere.center, sphere.radius, radiance, sphere.flip_normals ? Side::inwards : Side::outwards};
    }

    [[nodiscard]] std::optional<LightSample> sample(Vec3 from, const Point<2>& u) const {
        const Vec3 to_centre = centre_ - from;
        const double d = to_distance(to_centre);
        if (!shines_at(d)) return {};
        const double cone = one_minus_cos(d);
        const Vec3 local = sample_uniform_cone(u, cone);
        const Vec3 direction = d > 0 ? Frame(to_centre / d).to_world(local) : local;
        const double sin_squared = local.x * local.x + local.y * local.y;
        const double reach = distance(d, local.z, sin_squared);
        const Vec3 from_centre = normalize(direction * reach - to_centre);
        return LightSample{direction,           reach, radiance_, uniform_cone_pdf(local, cone), Measure::solid_angle,
                           shining(from_centre)};
    }
    [[nodiscard]] std::optional<LightHit> hit(Vec3 from, Vec3 direction) const {
        const Vec3 to_centre = centre_ - from;
        const double d = to_distance(to_centre);
        if (!shines_at(d)) return {};
        const double cos = d > 0 ? dot(direction, to_centre) / d : 1;
        const double sin_squared = d > 0 ? length_squared(cross(direction, to_centre)) / (d * d) : 0;
        if (d > radius_ && !(cos > 0 && d * d * sin_squared <= radius_ * radius_)) return {};
        return LightHit{distance(d, cos, sin_squared), radiance_, cone_pdf(d)};
    }
    /// The density of directions per steradian at `from`, the same for all that meet the light.
    [[nodiscard]] double pdf(Vec3 from) const {
        const double d = to_distance(centre_ - from);
        return shines_at(d) ? cone_pdf(d) : 0;
    }
    [[nodiscard]] EmittedRay sample_ray(const Ball&, const Point<2>& u, const Point<2>& v) const {
        return send_from(shining(sample_uniform_sphere(u)), radiance_, 1 / area(), v);
    }
    [[nodiscard]] EmittedRayPdf ray_pdf(const Ball&, Vec3 normal, Vec3 direction) const {
        return ray_pdf_from(1 / area(), normal, direction);
    }
    [[nodiscard]] Spectrum power(double) const { return lambertian_power(radiance_, area()); }

private:
    [[nodiscard]] double area() const { return 4 * pi * radius_ * radius_; }
    /// The point of the sphere in this direction from its centre, its normal on the shining side.
    [[nodiscard]] SurfacePoint shining(Vec3 from_centre) const {
        SurfacePoint point = sphere_point(centre_, radius_, from_centre);
        if (side_ == Side::inwards) point.normal = -point.normal;
        return point;
    }
    /// The distance to the centre. Rounding must not decide whether a point on a sphere that shines inwards is inside:
    /// whoever asks for a density later may have come to the point another way.
    [[nodiscard]] double to_distance(Vec3 to_centre) const {
        const double d = length(to_centre);
        return side_ == Side::inwards && d < radius_ * (1 + 1e-9) ? std::min(d, std::nextafter(radius_, 0)) : d;
    }
    [[nodiscard]] bool shines_at(double d) const { return side_ == Side::outwards ? d > radius_ : d < radius_; }
    /// The value 1 − cos for the half angle under which the sphere is seen from d: sin² = (R/d)², 1 − cos = sin²/(1 +
    /// cos).
    [[nodiscard]] double one_minus_cos(double d) const {
        if (d <= radius_) return 2;
        const double cos = std::sqrt((d - radius_) * (d + radius_)) / d;
        return radius_ / d * (radius_ / d) / (1 + cos);
    }
    [[nodiscard]] double cone_pdf(double d) const { return 1 / (2 * pi * one_minus_cos(d)); }
    /// The distance to the near side from outside, to the only side from inside.
    [[nodiscard]] double distance(double d, double cos, double sin_squared) const {
        const double half_chord = std::sqrt(std::max(0.0, radius_ * radius_ - d * d * sin_squared));
        return d > radius_ ? d * cos - half_chord : d * cos + half_chord;
    }

    Vec3 centre_;
    double radius_;
    Spectrum radiance_;
    Side side_;
};
static_assert(LightModel<SphereLight>);

}  // namespace plumb
