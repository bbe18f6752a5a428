#include "integrators/paths/next_event/light_choices.h"

namespace plumb {

namespace {

struct ByPower final : LightChoice {
    [[nodiscard]] std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                         SampleIndex index, Draws& draws) const override {
        const double u = draws.at(index.slot(Use::light))[0];
        return scene.sample_light(from.position, u, draws.at(index.slot(Use::light_point)));
    }
    [[nodiscard]] double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const override {
        if (point.light == scene.environment_light()) return scene.environment_pdf(from.position, point.direction);
        if (point.normal == Vec3{}) return scene.light_ray_pdf(point.light, {}, -point.direction).area;
        return scene.light_pdf(point.light, point.position, point.normal, from.position, point.direction);
    }
};

}  // namespace

std::shared_ptr<const LightChoice> choice_by_power() {
    static const auto choice = std::make_shared<const ByPower>();
    return choice;
}

}  // namespace plumb
