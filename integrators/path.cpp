#include "integrators/path.h"

#include "integrators/camera_path.h"

namespace plumb {

double survive_by_throughput(const Spectrum& throughput, double eta_squared) {
    return std::min(0.95, largest(throughput) * eta_squared);
}

namespace {

// Light that the state's ray met, weighted against what an emitter sample would have found there.
Spectrum met_light(const Scene& scene, const NextEvent& next_event, const PathState& state,
                   const std::optional<Hit>& hit, const PathRecord& record) {
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
                     .source = hit ? scene.light_of(*hit) : scene.environment_light()});
    return radiance * weight;
}

}  // namespace

void PathTracer::trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
                       PathRecord& record) const {
    record.clear();
    const CameraStart start = start_at_camera(scene, region, samples);
    std::optional<PathState> state =
        PathState{.ray = start.ray, .from = start.ray.origin, .direction = start.ray.direction};
    while (state) state = step(scene, start.film, *state, samples, record);
}

std::optional<PathState> PathTracer::step(const Scene& scene, const Point<2>& film, const PathState& state,
                                          PrimarySamples& samples, PathRecord& record) const {
    const std::optional<Hit> hit = trace_to_hit(scene, state.ray, state.vertex, samples, record);
    const auto add = [&](const Spectrum& light, int edges) {
        if (!is_black(light)) record.splats.push_back({film, state.throughput * light, edges});
    };
    const int edges = state.vertex;
    if (record.story) record.story->throughput = state.throughput;
    add(met_light(scene, next_event, state, hit, record), edges);
    if (!hit) return {};
    record.vertices.push_back(vertex_at(scene, *hit, state.ray));
    const PathVertex& vertex = record.vertices.back();
    if (!limits.allow(edges + 1)) return {};
    add(light_from_emitters(scene, vertex, state.vertex, LightTechniques::both, next_event, samples, record),
        edges + 1);
    return edges < last_vertex ? scatter(vertex, state, samples, record) : std::nullopt;
}

std::optional<PathState> PathTracer::scatter(const PathVertex& vertex, const PathState& state, PrimarySamples& samples,
                                             PathRecord& record) const {
    const auto sample = sample_bsdf(vertex, state.vertex, samples, Transport::radiance);
    if (!sample) return {};
    PathState next{.ray = leave(vertex.hit.point, sample->direction),
                   .from = vertex.hit.point.position,
                   .direction = sample->direction,
                   .throughput = state.throughput * sample->weight,
                   .pdf = sample->measure == Measure::solid_angle ? sample->pdf : 0,
                   .eta_squared = state.eta_squared * sample->eta * sample->eta,
                   .vertex = static_cast<std::uint16_t>(state.vertex + 1)};
    tell_scattering(record, state.vertex, *sample, next.throughput);
    if (is_black(next.throughput)) return {};
    if (next.vertex <= limits.roulette_edges) return next;
    const double survives = survival(next.throughput, next.eta_squared);
    if (!survives_roulette(survives, state.vertex, samples, record)) return {};
    next.throughput = next.throughput / survives;
    return next;
}

}  // namespace plumb
