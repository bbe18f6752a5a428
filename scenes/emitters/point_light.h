#pragma once

#include <array>

#include "estimators/densities/warps.h"
#include "scenes/description/models.h"
#include "scenes/emitters/light.h"

namespace plumb {

/// A point that shines with the same intensity (per steradian) to every side: what arrives falls as 1/d².
struct PointLight {
    static constexpr LightKind kind = LightKind::point;

    Vec3 position;
    Spectrum intensity;

    [[nodiscard]] std::optional<LightSample> sample(Vec3 from, const Point<2>&) const {
        const Vec3 way = position - from;
        const double squared = length_squared(way);
        if (!(squared > 0)) return {};
        const double distance = std::sqrt(squared);
        return LightSample{way / distance, distance, intensity / squared, 1, Measure::discrete};
    }
    [[nodiscard]] std::optional<LightHit> hit(Vec3, Vec3) const { return {}; }
    [[nodiscard]] EmittedRay sample_ray(const Ball&, const Point<2>&, const Point<2>& v) const {
        const Vec3 direction = sample_uniform_sphere(v);
        const double pdf = uniform_sphere_pdf(direction);
        return {position, direction, intensity / pdf, {1, pdf}};
    }
    [[nodiscard]] EmittedRayPdf ray_pdf(const Ball&, Vec3, Vec3 direction) const {
        return {1, uniform_sphere_pdf(direction)};
    }
    [[nodiscard]] Spectrum power(double) const { return intensity * (4 * std::numbers::pi); }
};
static_assert(LightModel<PointLight>);

namespace description {

/// The emitter `point` of scene files.
struct PointLight {
    Vec3 position;
    Spectrum intensity = Spectrum::grey(1);  ///< W/sr

    static constexpr std::array plugins{Plugin{"point", "one point with the same intensity to every side"}};
    static PointLight load(Properties& properties) {
        const Vec3 position = properties.vector("position", {});
        return {properties.transform("to_world").point(position), properties.emission("intensity", Spectrum::grey(1))};
    }
    [[nodiscard]] plumb::PointLight light() const { return {position, intensity}; }
};

}  // namespace description

}  // namespace plumb
