#pragma once

#include "integrators/estimators/path.h"
#include "integrators/paths/light_start.h"
#include "integrators/paths/next_event/visibility.h"

namespace plumb {

/// Light tracing: paths from lights, each of whose vertices is connected to the lens and falls wherever it is seen
/// [Arvo 1986; Veach 1997, section 10.2.1]. Lights and the environment as they are seen directly are found by a camera
/// ray of the region, and with them the layers of what is seen first.
struct LightTracer final : PathEstimator {
    PathLimits limits;
    SensorConnection connection = connect_to_lens;
    std::shared_ptr<const Visibility> visibility = shadow_rays();
    ShadingCorrection correction = shading_correction;
    Survival survival = survive_by_throughput;
    Transport carries = Transport::importance;

    LightTracer() = default;
    explicit LightTracer(const PathLimits& path_limits) : limits(path_limits) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;

private:
    void trace_from_light(const Scene& scene, Draws draws, PathRecord& record) const;
    /// Adds what the vertex sends to the lens for each unit of flux that reaches it.
    void splat(const Scene& scene, const PathVertex& vertex, const Spectrum& flux, int edges, const Draws& of_vertex,
               PathRecord& record) const;
};

}  // namespace plumb
