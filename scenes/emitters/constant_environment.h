#pragma once

#include <array>

#include "scenes/description/models.h"
#include "scenes/emitters/distant.h"

namespace plumb {

/// An environment with the same radiance from every direction.
struct ConstantEnvironment {
    static constexpr LightKind kind = LightKind::environment;

    Spectrum radiance;

    [[nodiscard]] std::optional<LightSample> sample(Vec3, const Point<2>& u) const {
        LightSample sample{.direction = sample_uniform_sphere(u), .radiance = radiance};
        sample.pdf = uniform_sphere_pdf(sample.direction);
        return sample;
    }
    [[nodiscard]] std::optional<LightHit> hit(Vec3, Vec3 direction) const {
        return LightHit{.radiance = radiance, .pdf = uniform_sphere_pdf(direction)};
    }
    [[nodiscard]] EmittedRay sample_ray(const Ball& scene, const Point<2>& u, const Point<2>& v) const {
        return send_from_afar(scene, *sample(scene.centre, v), u);
    }
    [[nodiscard]] EmittedRayPdf ray_pdf(const Ball& scene, Vec3, Vec3 direction) const {
        return ray_pdf_from_afar(scene, uniform_sphere_pdf(-direction));
    }
    /// The flux into the scene: from 4π steradians, through a disk of area π r².
    [[nodiscard]] Spectrum power(double scene_radius) const {
        return radiance * (4 * pi * pi * scene_radius * scene_radius);
    }
};
static_assert(LightModel<ConstantEnvironment>);

namespace description {

/// The emitter `constant` of scene files.
struct ConstantSky {
    Spectrum radiance = Spectrum::grey(1);

    static constexpr std::array plugins{Plugin{"constant", "the same radiance from every direction"}};
    static ConstantSky load(Properties& properties) { return {properties.emission("radiance", Spectrum::grey(1))}; }
    [[nodiscard]] ConstantEnvironment light() const { return {radiance}; }
};

}  // namespace description

}  // namespace plumb
