#include "integrators/paths/next_event/light_choice.h"

namespace plumb {

LightPoint light_point(const SceneLightSample& sample) {
    const auto& surface = sample.sample.surface;
    if (!surface) return {sample.light, sample.sample.direction};
    return {sample.light, sample.sample.direction, surface->position, surface->normal};
}

LightPoint light_point(const Scene& scene, const std::optional<Hit>& hit, Vec3 direction) {
    if (!hit) return {*scene.environment_light(), direction};
    return {*scene.light_of(*hit), direction, hit->point.position, hit->point.normal};
}

std::optional<SceneLightSample> ChoiceByProbability::sample(const Scene& scene, const SurfacePoint& from,
                                                            SampleIndex index, Draws& draws) const {
    if (scene.lights().empty()) return {};
    const auto [light, probability] = choose(scene, from, draws.at(index.slot(Use::light))[0]);
    const Point<2> u = draws.at(index.slot(Use::light_point));
    const auto found = scene.sample_of_light(light, from.position, u);
    if (!found) return {};
    return SceneLightSample{*found, probability * found->pdf, light};
}

double ChoiceByProbability::pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const {
    return pmf(scene, from, point.light) *
           pdf_of_sample(scene.lights()[point.light], from.position, point.direction, point.position, point.normal);
}

}  // namespace plumb
