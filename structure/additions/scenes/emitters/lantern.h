#pragma once

#include <array>

#include "estimators/densities/warps.h"
#include "scenes/description/models.h"
#include "scenes/emitters/light.h"

namespace plumb {

/// A point that shines to one side of a plane, with intensity (per steradian) in proportion to the cosine with its
/// axis.
struct Lantern {
    static constexpr LightKind kind = LightKind::point;

    Vec3 position;
    Frame frame;  ///< z is the axis
    Spectrum intensity;

    /// From the point, per steradian.
    [[nodiscard]] Spectrum intensity_along(Vec3 direction) const {
        return intensity * std::max(0.0, dot(direction, frame.z));
    }
    [[nodiscard]] std::optional<LightSample> sample(Vec3 from, const Point<2>&) const {
        const Vec3 way = position - from;
        const double squared = length_squared(way);
        if (!(squared > 0)) return {};
        const double distance = std::sqrt(squared);
        const Vec3 direction = way / distance;
        return LightSample{direction, distance, intensity_along(-direction) / squared, 1, Measure::discrete};
    }
    [[nodiscard]] std::optional<LightHit> hit(Vec3, Vec3) const { return {}; }
    /// The density is in proportion to the intensity: every ray has the whole power.
    [[nodiscard]] EmittedRay sample_ray(const Ball& scene, const Point<2>&, const Point<2>& v) const {
        const Vec3 direction = frame.to_world(sample_cosine_hemisphere(v));
        return {position, direction, power(scene.radius), ray_pdf(scene, {}, direction)};
    }
    [[nodiscard]] EmittedRayPdf ray_pdf(const Ball&, Vec3, Vec3 direction) const {
        return {1, cosine_hemisphere_pdf(frame.to_local(direction))};
    }
    [[nodiscard]] Spectrum power(double) const { return intensity * pi; }
};
static_assert(LightModel<Lantern>);

namespace description {

struct Lantern {
    Vec3 position, axis{0, 0, 1};
    Spectrum intensity = Spectrum::grey(1);  ///< W/sr, along the axis

    static constexpr std::array plugins{Plugin{"lantern", "one point that shines to one side"}};
    static Lantern load(Properties& properties) {
        const Vec3 position = properties.vector("position", {}), axis = properties.vector("direction", {0, 0, 1});
        const Transform to_world = properties.transform("to_world");
        return {to_world.point(position), to_world.vector(axis), properties.emission("intensity", Spectrum::grey(1))};
    }
    [[nodiscard]] plumb::Lantern light() const { return {position, Frame(normalize(axis)), intensity}; }
};

}  // namespace description

}  // namespace plumb
