#pragma once

#include "integrators/paths/limits.h"
#include "integrators/paths/next_event.h"

namespace plumb {

/// A path on its way from the sensor: everything that its next step depends on.
struct PathState {
    Ray ray;         ///< towards the next vertex
    Vec3 direction;  ///< of the ray before it was rounded
    Spectrum throughput = Spectrum::grey(1);
    double pdf = 0;            ///< of the direction, per steradian; 0 where no light sample competes: at the sensor and
                               ///< behind mirrors
    double eta_squared = 1;    ///< of the medium over the sensor's, squared
    std::uint16_t vertex = 1;  ///< the number of the next vertex, which is the edges up to it
};

/// Light that the state's ray met, by its weight against what samples of lights, and more of the BSDF, would have found
/// there. The density is that of the numbers behind the ray.
Spectrum weighted(const Spectrum& radiance, const Scene& scene, const NextEvent& next_event, const PathState& state,
                  const std::optional<Hit>& hit, double density, const PathRecord& record);

/// What the state's ray met of light, weighted. Inline, because most rays meet none.
inline Spectrum met_light(const Scene& scene, const NextEvent& next_event, const PathState& state,
                          const std::optional<Hit>& hit, double density, const PathRecord& record) {
    const Spectrum radiance = hit ? scene.emitted(*hit, -state.direction) : scene.environment(state.ray);
    if (is_black(radiance)) return radiance;
    return weighted(radiance, scene, next_event, state, hit, density, record);
}

/// Path tracing: next-event estimation and BSDF samples with multiple importance sampling at each vertex. Light behind
/// mirrors counts even where no sample of the BSDF is to find light: nothing else would
/// [Kajiya 1986; Veach & Guibas 1995].
struct PathTracer final : PathEstimator {
    PathLimits limits;
    NextEvent next_event;  ///< the first sample of a vertex's BSDF is the path's own way on
    Survival survival = survive_by_throughput;

    PathTracer() = default;
    explicit PathTracer(const PathLimits& path_limits) : limits(path_limits) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;
    /// HybridShift.
    [[nodiscard]] std::unique_ptr<PathShift> shift() const override;

    /// One step: the ray is traced, light that it meets and light at the vertex are added to the record, and a new
    /// direction is chosen. False where the path ends.
    bool step(const Scene& scene, const Point<2>& film, PathState& state, Draws& draws, PathRecord& record) const;

private:
    bool scatter(const PathVertex& vertex, PathState& state, Draws& draws, PathRecord& record) const;
};

}  // namespace plumb
