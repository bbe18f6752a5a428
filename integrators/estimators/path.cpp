#include "integrators/estimators/path.h"

#include "integrators/paths/vertex.h"

namespace plumb {

Spectrum met_light(const Scene& scene, const NextEvent& next_event, const PathState& state,
                   const std::optional<Hit>& hit, double density, const PathRecord& record) {
    const Spectrum radiance = hit ? scene.emitted(*hit, -state.direction) : scene.environment(state.ray);
    if (is_black(radiance)) return radiance;
    const double light_pdf = state.pdf == 0 ? 0
                             : hit          ? scene.light_pdf(*hit, state.from, state.direction)
                                            : scene.environment_pdf(state.from, state.direction);
    const double weight = state.pdf == 0 ? 1 : next_event.weight(state.pdf, light_pdf);
    if (record.story)
        record.tell({.strategy = {0, state.vertex + 1},
                     .light = radiance,
                     .weight = weight,
                     .pdf = state.pdf,
                     .rival = light_pdf,
                     .source = hit ? scene.light_of(*hit) : scene.environment_light(),
                     .density = density});
    return radiance * weight;
}

void PathTracer::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
                       PathRecord& record) const {
    record.clear();
    Draws draws(samples);
    const CameraStart start = start_at_camera(scene, region, draws);
    PathState state{.ray = start.ray, .from = start.ray.origin, .direction = start.ray.direction};
    while (step(scene, start.film, state, draws, record)) {
    }
}

bool PathTracer::step(const Scene& scene, const Point<2>& film, PathState& state, Draws& draws,
                      PathRecord& record) const {
    const std::optional<Hit> hit = trace_to_hit(scene, state.ray, state.vertex, draws, record);
    const auto add = [&](const Spectrum& light, int edges) {
        if (!is_black(light)) record.add({film, state.throughput * light, edges}, draws.density());
    };
    const int edges = state.vertex;
    if (record.story) record.story->throughput = state.throughput;
    add(met_light(scene, next_event, state, hit, draws.density(), record), edges);
    if (!hit) return false;
    const PathVertex& vertex = record.meet(vertex_at(scene, *hit, state.ray), draws.density());
    if (!limits.allow(edges + 1)) return false;
    add(light_from_emitters(scene, vertex, state.vertex, LightTechniques::both, next_event, draws, record), edges + 1);
    return edges < last_vertex && scatter(vertex, state, draws, record);
}

bool PathTracer::scatter(const PathVertex& vertex, PathState& state, Draws& draws, PathRecord& record) const {
    const std::uint16_t number = state.vertex++;
    const auto sample = sample_bsdf(vertex, number, draws, Transport::radiance);
    if (!sample) return false;
    state.ray = leave(vertex.hit.point, sample->direction);
    state.from = vertex.hit.point.position;
    state.direction = sample->direction;
    state.throughput *= sample->weight;
    state.pdf = sample->measure == Measure::solid_angle ? sample->pdf : 0;
    state.eta_squared *= sample->eta * sample->eta;
    tell_scattering(record, number, *sample, state.throughput);
    if (is_black(state.throughput)) return false;
    if (state.vertex <= limits.roulette_edges) return true;
    const double survives = survival(state.throughput, state.eta_squared);
    if (!survives_roulette(survives, number, draws, record)) return false;
    state.throughput = state.throughput / survives;
    return true;
}

}  // namespace plumb
