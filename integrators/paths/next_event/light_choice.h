#pragma once

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// A point of a light as a vertex sees it, whoever found it.
struct LightPoint {
    std::size_t light;                ///< index into Scene::lights()
    Vec3 direction;                   ///< towards it, unit
    Vec3 position = {}, normal = {};  ///< of surfaces, whose normal is on the side asked about; points and environments
                                      ///< have none
};
/// The point that a sample of lights found.
LightPoint light_point(const SceneLightSample& sample);
/// The point that a ray of this direction met: of a surface that shines, or of the environment where it met nothing.
LightPoint light_point(const Scene& scene, const std::optional<Hit>& hit, Vec3 direction);

/// Samples a light and a point of it for a vertex, and knows the density of any such point. It is a function of the
/// vertex's point alone, not of where a path came from: bidirectional tracing asks from both ends. Any choice will do
/// that finds each light that shines on the vertex with a positive density.
struct LightChoice {
    virtual ~LightChoice() = default;
    /// A point of a light, whose pdf is what pdf() says of it; empty where no light is found: that sample is black.
    [[nodiscard]] virtual std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                                 SampleIndex index, Draws& draws) const = 0;
    /// The density of a point, per steradian at `from`; for a point light the probability. 0 for the side of a surface
    /// that does not shine.
    [[nodiscard]] virtual double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const = 0;
};

/// A choice of a light by probabilities that may depend on the vertex, then of a point as the light samples itself.
struct ChoiceByProbability : LightChoice {
    [[nodiscard]] std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                         SampleIndex index, Draws& draws) const final;
    [[nodiscard]] double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const final;

    /// The light for u in [0,1) and its probability; the scene has at least one.
    [[nodiscard]] virtual ChosenLight choose(const Scene& scene, const SurfacePoint& from, double u) const = 0;
    [[nodiscard]] virtual double pmf(const Scene& scene, const SurfacePoint& from, std::size_t light) const = 0;
};

}  // namespace plumb
