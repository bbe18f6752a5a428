#include "integrators/paths/next_event.h"

#include "integrators/paths/vertex.h"

namespace plumb {

namespace {

std::optional<SceneLightSample> choose_by_power(const Scene& scene, const PathVertex& vertex, Draws& draws,
                                                std::uint16_t number) {
    const double u = draws.at({number, Use::light})[0];
    return scene.sample_light(vertex.hit.point.position, u, draws.at({number, Use::light_point}));
}

double trace_shadow(const Scene& scene, const PathVertex& vertex, const EmitterSample& light, PathRecord& record) {
    return scene.transmittance(vertex.hit.point, light, record.rays);
}

}  // namespace

NextEvent default_next_event() {
    return {choose_by_power, trace_shadow, mis_weight};
}

Spectrum light_from_emitters(const Scene& scene, const PathVertex& vertex, std::uint16_t number, LightTechniques used,
                             const NextEvent& next_event, const Draws& of_vertex, PathRecord& record) {
    if (!vertex.bsdf.smooth()) return {};
    Draws draws = of_vertex.branch();
    const auto light = next_event.choose(scene, vertex, draws, number);
    if (!light) return {};
    const Spectrum f = eval_bsdf(vertex, light->sample.direction, Transport::radiance);
    if (is_black(f)) return {};
    const double visible = next_event.visibility(scene, vertex, light->sample, record);
    if (visible == 0) {
        if (record.story)
            record.tell({.strategy = {1, number + 1}, .light = {}, .pdf = light->pdf, .source = light->light});
        return {};
    }
    const bool shared = used == LightTechniques::both && light->sample.measure == Measure::solid_angle;
    const auto bsdf_pdf = [&] {
        return vertex.bsdf.pdf(vertex.to_local(vertex.wo), vertex.to_local(light->sample.direction));
    };
    const double rival = shared ? bsdf_pdf() : 0;
    const double weight = shared ? next_event.weight(light->pdf, rival) : 1;
    if (record.story)
        record.tell({.strategy = {1, number + 1},
                     .light = f * light->sample.radiance * (visible / light->pdf),
                     .weight = weight,
                     .pdf = light->pdf,
                     .rival = rival,
                     .source = light->light,
                     .density = of_vertex.density() * draws.density()});
    return f * light->sample.radiance * (weight * visible / light->pdf) / draws.density();
}

Spectrum light_from_bsdf(const Scene& scene, const PathVertex& vertex, std::uint16_t number, LightTechniques used,
                         const NextEvent& next_event, const Draws& of_vertex, PathRecord& record) {
    Draws draws = of_vertex.branch();
    const auto sample = sample_bsdf(vertex, number, draws, Transport::radiance);
    if (!sample) return {};
    tell_scattering(record, number, *sample, sample->weight);
    const Vec3 wi = sample->direction, from = vertex.hit.point.position;
    const Ray ray = leave(vertex.hit.point, wi);
    const auto next = trace_to_hit(scene, ray, static_cast<std::uint16_t>(number + 1), draws, record);
    const Spectrum radiance = next ? scene.emitted(*next, -wi) : scene.environment(ray);
    if (is_black(radiance)) return {};
    const bool shared = used == LightTechniques::both && sample->measure == Measure::solid_angle;
    const double light_pdf = !shared ? 0 : next ? scene.light_pdf(*next, from, wi) : scene.environment_pdf(from, wi);
    const double weight = shared ? next_event.weight(sample->pdf, light_pdf) : 1;
    if (record.story)
        record.tell({.strategy = {0, number + 2},
                     .light = sample->weight * radiance,
                     .weight = weight,
                     .pdf = shared ? sample->pdf : 0,
                     .rival = light_pdf,
                     .source = next ? scene.light_of(*next) : scene.environment_light(),
                     .density = of_vertex.density() * draws.density()});
    return sample->weight * radiance * weight / draws.density();
}

}  // namespace plumb
