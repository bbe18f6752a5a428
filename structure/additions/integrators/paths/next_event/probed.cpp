#include "integrators/paths/next_event/probed.h"

#include <numeric>

namespace plumb {

namespace {

struct Probed final : ChoiceByProbability {
    [[nodiscard]] ChosenLight choose(const Scene& scene, const SurfacePoint& from, double u) const override {
        const std::vector<double> chances = chances_at(scene, from);
        std::size_t light = 0;
        while (light + 1 < chances.size() && u >= chances[light]) u -= chances[light++];
        return {light, chances[light]};
    }
    [[nodiscard]] double pmf(const Scene& scene, const SurfacePoint& from, std::size_t light) const override {
        return chances_at(scene, from)[light];
    }

private:
    static double probe(const Light& light, const SurfacePoint& from) {
        const auto middle = std::visit([&](const auto& one) { return one.sample(from.position, {0.5, 0.5}); }, light);
        const double arriving = middle ? luminance(middle->radiance / middle->pdf) : 0;
        return std::isfinite(arriving) ? arriving : 0;
    }
    static std::vector<double> chances_at(const Scene& scene, const SurfacePoint& from) {
        std::vector<double> chances;
        for (const Light& light : scene.lights()) chances.push_back(probe(light, from));
        const double sum = std::accumulate(chances.begin(), chances.end(), 0.0);
        const double alike = 1 / static_cast<double>(chances.size());
        for (double& chance : chances) chance = sum > 0 ? 0.1 * alike + 0.9 * chance / sum : alike;
        return chances;
    }
};

}  // namespace

std::shared_ptr<const LightChoice> probed_choice() {
    static const auto choice = std::make_shared<const Probed>();
    return choice;
}

}  // namespace plumb
