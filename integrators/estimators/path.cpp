#include "integrators/estimators/path.h"

#include "integrators/paths/vertex.h"

namespace plumb {

namespace {

// The weight of light that the state's ray met, against what samples of lights, and more of the BSDF, would have
// found there.
TechniqueWeight weight_of_met(const Scene& scene, const NextEvent& next_event, const PathState& state,
                              const std::optional<Hit>& hit, const PathRecord& record) {
    if (state.vertex == 1) return {1, 0};
    const int count = next_event.bsdf_count;
    if (state.pdf == 0) return {1.0 / std::max(1, count), 0};
    if (count == 0) return {0, 0};
    const LightPoint point = light_point(scene, hit, state.direction);
    TechniqueWeight weight = weight_of_bsdf(next_event, scene, record.vertices.back(), point, state.pdf);
    weight.weight /= count;
    return weight;
}

}  // namespace

Spectrum weighted(const Spectrum& radiance, const Scene& scene, const NextEvent& next_event, const PathState& state,
                  const std::optional<Hit>& hit, double density, const PathRecord& record) {
    const auto [weight, rivals] = weight_of_met(scene, next_event, state, hit, record);
    if (record.story)
        record.tell({.strategy = {0, state.vertex + 1},
                     .light = radiance,
                     .weight = weight,
                     .pdf = state.pdf,
                     .rival = rivals,
                     .source = hit ? scene.light_of(*hit) : scene.environment_light(),
                     .density = density});
    return radiance * weight;
}

void PathTracer::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
                       PathRecord& record) const {
    record.clear();
    Draws draws(samples);
    const CameraStart start = start_at_camera(scene, region, draws);
    PathState state{.ray = start.ray, .direction = start.ray.direction};
    while (step(scene, start.film, state, draws, record)) {
    }
}

bool PathTracer::step(const Scene& scene, const Point<2>& film, PathState& state, Draws& draws,
                      PathRecord& record) const {
    const std::optional<Hit> hit = trace_to_hit(scene, state.ray, {state.vertex}, draws, record);
    const auto add = [&](const Spectrum& light, int edges) {
        if (!is_black(light)) record.add({film, state.throughput * light, edges}, draws.density());
    };
    const int edges = state.vertex;
    if (record.story) record.story->throughput = state.throughput;
    add(met_light(scene, next_event, state, hit, draws.density(), record), edges);
    if (!hit) return false;
    const PathVertex& vertex = record.meet(vertex_at(scene, *hit, state.ray), draws.density());
    if (!limits.allow(edges + 1)) return false;
    Spectrum light = gather_from_lights(scene, vertex, state.vertex, next_event, draws, record);
    if (next_event.bsdf_count > 1) light += gather_from_bsdf(scene, vertex, state.vertex, next_event, draws, record, 1);
    add(light, edges + 1);
    return edges < last_vertex && scatter(vertex, state, draws, record);
}

bool PathTracer::scatter(const PathVertex& vertex, PathState& state, Draws& draws, PathRecord& record) const {
    const std::uint16_t number = state.vertex++;
    const auto sample = sample_bsdf(vertex, {number}, draws, Transport::radiance);
    if (!sample) return false;
    state.ray = leave(vertex.hit.point, sample->direction);
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
