#include "integrators/estimators/ambient.h"

#include "integrators/paths/vertex.h"

namespace plumb {

void Ambient::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record) const {
    record.clear();
    Draws draws(samples);
    const CameraStart start = start_at_camera(scene, region, draws);
    const auto vertex = trace_to_vertex(scene, start.ray, 1, draws, record);
    if (!vertex) return;
    record.meet(*vertex, draws.density());
    const auto scattered = sample_bsdf(*vertex, {1}, draws, Transport::radiance);
    if (!scattered) return;
    if (trace_to_hit(scene, leave(vertex->hit.point, scattered->direction), {2}, draws, record)) return;
    record.add({start.film, scattered->weight, 2}, draws.density());
}

std::unique_ptr<PathEstimator> make_ambient(const PathLimits&, const Parameters&) {
    return std::make_unique<Ambient>();
}

}  // namespace plumb
