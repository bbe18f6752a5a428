#include "integrators/estimators/direct.h"

#include "integrators/paths/vertex.h"

namespace plumb {

void trace_two_edges(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record,
                     const ReflectedLight& reflected) {
    record.clear();
    Draws draws(samples);
    const CameraStart start = start_at_camera(scene, region, draws);
    const auto vertex = trace_to_vertex(scene, start.ray, 1, draws, record);
    const Spectrum seen = vertex ? scene.emitted(vertex->hit, vertex->wo) : scene.environment(start.ray);
    if (record.story && !is_black(seen))
        record.tell({.strategy = {0, 2},
                     .light = seen,
                     .source = vertex ? scene.light_of(vertex->hit) : scene.environment_light(),
                     .density = draws.density()});
    record.add({start.film, seen, 1}, draws.density());
    if (!vertex) return;
    record.meet(*vertex, draws.density());
    record.add({start.film, reflected(scene, *vertex, draws, record), 2}, draws.density());
}

void Direct::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, PathRecord& record) const {
    trace_two_edges(scene, region, samples, record,
                    [this](const Scene& in, const PathVertex& vertex, const Draws& numbers, PathRecord& rays) {
                        return gather_from_lights(in, vertex, 1, next_event, numbers, rays) +
                               gather_from_bsdf(in, vertex, 1, next_event, numbers, rays);
                    });
}

}  // namespace plumb
