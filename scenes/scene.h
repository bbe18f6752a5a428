#pragma once

#include <optional>
#include <vector>

#include "scenes/bsdfs/materials.h"
#include "scenes/description.h"
#include "scenes/emitters/light_chooser.h"
#include "scenes/emitters/lights.h"
#include "scenes/geometry/embree_scene.h"
#include "scenes/sensors/scene_sensor.h"

namespace plumb {

/// A light of the scene, chosen, with a direction towards it; pdf is the density of the pair.
struct SceneLightSample {
    LightSample sample;
    double pdf = 0;
    std::size_t light = 0;  ///< index into lights()
};

/// A ray that a light of the scene sends.
struct SceneLightRay {
    EmittedRay ray;  ///< its weight is divided by the light's chance, and times the opacity of a masked light there
    std::size_t light;
    double chance;
};

/// A description made ready for light transport. Immutable: threads share it.
class Scene {
public:
    /// The choice of lights of given powers.
    using MakeChooser = LightChooser (*)(const std::vector<Spectrum>& powers);

    /// Prepares the description: reads textures and environment maps, builds Embree's tree. Throws Error naming file
    /// and line.
    explicit Scene(description::Scene description, MakeChooser choose = LightChooser::half_by_power);

    [[nodiscard]] const SceneSensor& sensor() const { return sensor_; }

    /// The surface that a ray meets first. u decides whether the ray passes masks on its way.
    [[nodiscard]] std::optional<Hit> intersect(const Ray& ray, double u, RayLog& log) const;
    [[nodiscard]] bool has_masks() const { return has_masks_; }
    /// The chance that a ray that reaches the surface stops there: below 1 for masks.
    [[nodiscard]] double opacity(const Hit& hit) const { return materials_.opacity(shape(hit).material, hit.uv); }
    /// The share of the light of a light's sample that arrives: 0 or 1, in between behind masks.
    [[nodiscard]] double transmittance(const SurfacePoint& from, const LightSample& sample, RayLog& log) const;

    /// The closure at a hit for light that leaves towards `wo` (in the world).
    [[nodiscard]] Bsdf bsdf(const Hit& hit, Vec3 wo) const;

    /// The radiance that a hit surface emits towards `wo`.
    [[nodiscard]] Spectrum emitted(const Hit& hit, Vec3 wo) const;
    /// The radiance that the environment sends along a ray that met nothing.
    [[nodiscard]] Spectrum environment(const Ray& ray) const;

    /// Chooses a light, then a direction towards it; empty where it does not shine, or there is no light.
    [[nodiscard]] std::optional<SceneLightSample> sample_light(Vec3 from, double u, const Point<2>& v) const;
    /// A direction towards this light, as sample_light draws it: a point of a masked light sends its radiance times its
    /// opacity, for that is what a ray which meets it finds on average.
    [[nodiscard]] std::optional<LightSample> sample_of_light(std::size_t light, Vec3 from, const Point<2>& v) const;
    /// The density, per steradian, with which sample_light(from) would have found the light that a ray met.
    [[nodiscard]] double light_pdf(const Hit& hit, Vec3 from, Vec3 direction) const;
    /// The same density for this light, which has a surface, at a point where it shines to the side of `normal`.
    [[nodiscard]] double light_pdf(std::size_t light, Vec3 position, Vec3 normal, Vec3 from, Vec3 direction) const;
    /// The same density for the environment; 0 without one.
    [[nodiscard]] double environment_pdf(Vec3 from, Vec3 direction) const;

    /// Chooses a light and a ray that it sends; empty without lights.
    [[nodiscard]] std::optional<SceneLightRay> sample_light_ray(double u, const Point<2>& origin,
                                                                const Point<2>& direction) const;
    /// The densities of such a ray of this light along `direction`, from where it shines to the side of `normal` (an
    /// environment and a point have none: any will do); `area` includes the choice of the light.
    [[nodiscard]] EmittedRayPdf light_ray_pdf(std::size_t light, Vec3 normal, Vec3 direction) const;
    /// The light that a hit surface is; empty where the surface does not shine.
    [[nodiscard]] std::optional<std::size_t> light_of(const Hit& hit) const;
    [[nodiscard]] std::optional<std::size_t> environment_light() const { return environment_; }
    /// A ball around all shapes: environments shine into it.
    [[nodiscard]] const Ball& ball() const { return ball_; }

    [[nodiscard]] const description::Scene& description() const { return description_; }
    [[nodiscard]] const EmbreeScene& embree() const { return embree_; }
    [[nodiscard]] const std::vector<Light>& lights() const { return lights_; }
    /// The least probability with which a light that shines is chosen; 1 without lights.
    [[nodiscard]] double least_light_chance() const;
    /// A radiance of the scene's scale: of a sky of the same power as all lights together. It is proportional to what
    /// lights emit.
    [[nodiscard]] double scale_of_light() const;

private:
    /// The opacity of the light where it chose a point for u; 1 where it is no surface.
    [[nodiscard]] double opacity_of_light(std::size_t light, const Point<2>& u,
                                          const std::optional<SurfacePoint>& at) const;
    [[nodiscard]] const description::Shape& shape(const Hit& hit) const { return description_.shapes[hit.shape]; }

    description::Scene description_;
    Ball ball_;
    EmbreeScene embree_;
    Materials materials_;
    SceneSensor sensor_;
    std::vector<Light> lights_;
    std::vector<std::size_t> light_of_shape_;  // lights_.size() where it does not shine
    std::optional<std::size_t> environment_;
    std::optional<LightChooser> chooser_;  // empty without lights
    bool has_masks_ = false;
    std::vector<std::size_t> shape_of_light_;  // of lights with a surface, which come first
};

}  // namespace plumb
