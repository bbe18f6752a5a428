#include "integrators/estimators/light_tracer.h"

namespace plumb {

void LightTracer::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
                        PathRecord& record) const {
    record.clear();
    Draws draws(samples);
    const CameraStart start = start_at_camera(scene, region, draws);
    const auto seen = trace_to_vertex(scene, start.ray, 1, draws, record);
    const Spectrum radiance = seen ? scene.emitted(seen->hit, seen->wo) : scene.environment(start.ray);
    if (!is_black(radiance)) {
        if (record.story)
            record.tell({.strategy = {0, 2},
                         .light = radiance,
                         .source = seen ? scene.light_of(seen->hit) : scene.environment_light(),
                         .density = draws.density()});
        record.add({start.film, radiance, 1}, draws.density());
    }
    if (seen) record.meet(*seen, draws.density());
    if (limits.allow(2)) trace_from_light(scene, Draws(samples), record);
}

void LightTracer::trace_from_light(const Scene& scene, Draws draws, PathRecord& record) const {
    const auto start = start_at_light(scene, draws, record);
    if (!start) return;
    Ray ray = start->ray;
    Spectrum throughput = Spectrum::grey(1);
    for (int edges = 1; edges < last_vertex && limits.allow(edges + 1); ++edges) {
        const auto number = static_cast<std::uint16_t>(first_light_vertex + edges);
        const auto vertex = trace_to_vertex(scene, ray, number, draws, record);
        if (!vertex) return;
        record.light_vertices.push_back(*vertex);
        splat(scene, *vertex, start->light.ray.weight * throughput, edges + 1, draws, record);
        const auto sample = sample_importance(*vertex, number, draws, correction, carries);
        if (!sample) return;
        throughput *= sample->weight;
        tell_scattering(record, number, *sample, throughput);
        if (is_black(throughput)) return;
        if (edges + 1 > limits.roulette_edges) {
            const double survives = survival(throughput, 1);
            if (!survives_roulette(survives, number, draws, record)) return;
            throughput = throughput / survives;
        }
        ray = leave(vertex->hit.point, sample->direction);
    }
}

void LightTracer::splat(const Scene& scene, const PathVertex& vertex, const Spectrum& flux, int edges,
                        const Draws& of_vertex, PathRecord& record) const {
    if (!vertex.bsdf.smooth()) return;
    const auto number = static_cast<std::uint16_t>(first_light_vertex + edges - 1);
    Draws draws = of_vertex;
    const auto lens = sample_lens(scene, vertex.hit.point.position, number, draws, connection);
    if (!lens) return;
    const Spectrum f = eval_bsdf(vertex, lens->direction, Transport::importance);
    if (is_black(f)) return;
    const double arrives =
        visibility->sample(scene, vertex.hit.point, end_at_lens(*lens), {number}, draws, record.rays);
    if (arrives == 0) return;
    const double scale = correction(vertex, lens->direction) * arrives * lens->importance / lens->pdf;
    const Spectrum value = flux * f * scale;
    if (record.story) record.tell({.strategy = {edges, 1}, .light = value, .density = draws.density()});
    record.add({lens->film, value, edges, true}, draws.density());
}

}  // namespace plumb
