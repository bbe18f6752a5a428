#include "integrators/paths/light_start.h"

namespace plumb {

std::optional<LightStart> start_at_light(const Scene& scene, Draws& draws, const PathRecord& record) {
    const double u = draws.at({first_light_vertex, Use::light})[0];
    const Point<2> origin = draws.at({first_light_vertex, Use::light_point});
    const double origin_density = draws.density();
    const auto light = scene.sample_light_ray(u, origin, draws.at({first_light_vertex, Use::direction}));
    if (!light) return {};
    if (record.story) record.story->light_ray = *light;
    const EmittedRay& ray = light->ray;
    return LightStart{*light, ray.surface ? leave(*ray.surface, ray.direction) : rounded_ray(ray.origin, ray.direction),
                      origin_density};
}

std::optional<ScatterSample> sample_importance(const PathVertex& vertex, std::uint16_t number, Draws& draws,
                                               ShadingCorrection correction, Transport carries) {
    auto sample = sample_bsdf(vertex, {number}, draws, carries);
    if (sample) sample->weight *= correction(vertex, sample->direction);
    return sample;
}

std::optional<SensorSample> connect_to_lens(const Scene& scene, Vec3 from, const Point<2>& lens) {
    return scene.sensor().connect(from, lens);
}

LightSample end_at_lens(const SensorSample& sensor) {
    return {.direction = sensor.direction, .distance = sensor.distance, .radiance = {}};
}

}  // namespace plumb
