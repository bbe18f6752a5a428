#include "integrators/direct.h"

#include "integrators/camera_path.h"

namespace plumb {

void Direct::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record) const {
    record.clear();
    const CameraStart start = start_at_camera(scene, region, samples);
    const auto vertex = trace_to_vertex(scene, start.ray, 1, samples, record);
    if (!vertex) {
        record.splats.push_back({start.film, scene.environment(start.ray), 1});
        return;
    }
    record.vertices.push_back(*vertex);
    record.splats.push_back({start.film, scene.emitted(vertex->hit, vertex->wo), 1});
    Spectrum reflected;
    if (used != LightTechniques::bsdf)
        reflected += light_from_emitters(scene, *vertex, 1, used, next_event, samples, record);
    if (used != LightTechniques::emitters)
        reflected += light_from_bsdf(scene, *vertex, 1, used, next_event, samples, record);
    record.splats.push_back({start.film, reflected, 2});
}

}  // namespace plumb
