#include "integrators/estimators/aov.h"

#include "integrators/paths/vertex.h"

namespace plumb {

void Aov::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record) const {
    record.clear();
    Draws draws(samples);
    const CameraStart start = start_at_camera(scene, region, draws);
    const auto vertex = trace_to_vertex(scene, start.ray, 1, draws, record);
    if (!vertex) return;
    record.meet(*vertex, draws.density());
    record.add({start.film, albedo(vertex->bsdf), 1}, draws.density());
}

}  // namespace plumb
