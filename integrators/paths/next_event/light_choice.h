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
/// That a sample of lights found.
LightPoint light_point(const SceneLightSample& sample);
/// That a ray of this direction met: a surface that shines, or, where it met nothing, the environment.
LightPoint light_point(const Scene& scene, const std::optional<Hit>& hit, Vec3 direction);

/// Samples a light and a point of it for a vertex, and knows the density of any. A function of the vertex's point
/// alone, not of where a path came from: bidirectional tracing asks from both ends. Any choice will do that finds each
/// light that shines on the vertex with a positive density.
struct LightChoice {
    virtual ~LightChoice() = default;
    /// Empty where no light is found: that sample is black. Its pdf is pdf() of what it found.
    [[nodiscard]] virtual std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                                 SampleIndex index, Draws& draws) const = 0;
    /// Per steradian at `from`; of a point light the probability. 0 for the side of a surface that does not shine.
    [[nodiscard]] virtual double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const = 0;
};

/// A choice of a light by probabilities that may depend on the vertex, then of a point as the light samples itself.
struct ChoiceByProbability : LightChoice {
    [[nodiscard]] std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                         SampleIndex index, Draws& draws) const final;
    [[nodiscard]] double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const final;

    /// A light by u in [0,1); the scene has one.
    [[nodiscard]] virtual ChosenLight choose(const Scene& scene, const SurfacePoint& from, double u) const = 0;
    [[nodiscard]] virtual double pmf(const Scene& scene, const SurfacePoint& from, std::size_t light) const = 0;
};

}  // namespace plumb
