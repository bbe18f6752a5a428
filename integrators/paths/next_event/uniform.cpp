#include "integrators/paths/next_event/light_choices.h"

namespace plumb {

namespace {

struct Uniform final : ChoiceByProbability {
    [[nodiscard]] ChosenLight choose(const Scene& scene, const SurfacePoint& from, double u) const override {
        const std::size_t count = scene.lights().size();
        const auto light = std::min(static_cast<std::size_t>(u * static_cast<double>(count)), count - 1);
        return {light, pmf(scene, from, light)};
    }
    [[nodiscard]] double pmf(const Scene& scene, const SurfacePoint&, std::size_t) const override {
        return 1 / static_cast<double>(scene.lights().size());
    }
};

}  // namespace

std::shared_ptr<const LightChoice> uniform_choice() {
    static const auto choice = std::make_shared<const Uniform>();
    return choice;
}

}  // namespace plumb
