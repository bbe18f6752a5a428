#include "integrators/estimators/aov.h"

#include "integrators/paths/vertex.h"

namespace plumb {

void Aov::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record) const {
    record.clear();
    const CameraStart start = start_at_camera(scene, region, samples);
    const auto vertex = trace_to_vertex(scene, start.ray, 1, samples, record);
    if (!vertex) return;
    record.vertices.push_back(*vertex);
    record.splats.push_back({start.film, albedo(vertex->bsdf), 1});
}

}  // namespace plumb
