#include "integrators/paths/path_chain.h"

namespace plumb {

using Kind = SubpathVertex::Kind;

namespace {

void lay_out(std::span<const SubpathVertex> camera, std::span<const SubpathVertex> light, PathChain& chain) {
    chain.vertices.clear();
    chain.from_camera.clear();
    chain.from_light.clear();
    chain.discrete.clear();
    for (const SubpathVertex& vertex : camera) {
        chain.vertices.push_back(&vertex);
        chain.from_camera.push_back(vertex.pdf);
        chain.from_light.push_back(vertex.pdf_back);
        chain.discrete.push_back(vertex.discrete);
    }
    for (std::size_t j = light.size(); j-- > 0;) {
        chain.vertices.push_back(&light[j]);
        chain.from_camera.push_back(light[j].pdf_back);
        chain.from_light.push_back(light[j].pdf);
        chain.discrete.push_back(light[j].discrete);
    }
}

}  // namespace

void join(const Scene& scene, const LightChoice& choice, std::span<const SubpathVertex> camera,
          std::span<const SubpathVertex> light, PerArea per_area, PathChain& chain) {
    lay_out(camera, light, chain);
    const auto& z = chain.vertices;
    const std::size_t t = camera.size(), n = z.size() - 1;
    const auto onwards = [&](std::size_t before, std::size_t at, std::size_t next) {
        return density_onwards(scene, before < z.size() ? z[before] : nullptr, *z[at], *z[next], per_area);
    };
    constexpr std::size_t none = -1;
    // Subpaths know the densities of their vertices but for the two at the connection, which depend on the other one.
    chain.discrete[t - 1] = false;
    if (t <= n) {
        chain.discrete[t] = false;
        chain.from_camera[t] = onwards(t >= 2 ? t - 2 : none, t - 1, t);
        if (t >= 2) chain.from_light[t - 1] = onwards(t + 1, t, t - 1);
        if (t + 1 <= n) chain.from_camera[t + 1] = onwards(t - 1, t, t + 1);
    } else {
        chain.from_light[n] = density_of_origin(scene, *z[n], *z[n - 1]);
    }
    if (t >= 3) chain.from_light[t - 2] = onwards(t, t - 1, t - 2);
    chain.choice = n >= 2 ? density_of_choice(scene, choice, *z[n], *z[n - 1], per_area) : 0;
}

bool can_make(const PathChain& chain, int t) {
    const int n = chain.edges();
    const Kind light = chain.vertices[static_cast<std::size_t>(n)]->kind;
    if (t == n + 1) return light != Kind::point_light;
    const auto smooth = [&](int i) { return !chain.discrete[static_cast<std::size_t>(i)]; };
    // What is seen directly: neither directions nor points can be connected to the lens.
    if (n == 1) return light != Kind::point_light && light != Kind::environment;
    return smooth(t - 1) && smooth(t);
}

double strategy_weight(const PathChain& chain, int t) {
    const int n = chain.edges();
    const auto at = [](const std::vector<double>& densities, int i) { return densities[static_cast<std::size_t>(i)]; };
    const auto choice = [&](int strategy) {
        return n >= 2 && strategy == n ? chain.choice / at(chain.from_light, n) : 1;
    };
    double sum = 1;
    // Goes on to the strategy that finds vertex i from the other side; false where no further one can. Densities of the
    // own strategy are positive, but a sample at grazing incidence may see the other side of zero.
    const auto step = [&](double& ratio, double theirs, double ours, int strategy) {
        if (!(theirs > 0)) return false;
        ratio *= theirs / ours;
        if (can_make(chain, strategy) && choice(strategy) > 0) {
            const double density = ratio * (choice(strategy) / choice(t));
            sum += density * density;
        }
        return true;
    };
    double ratio = 1;
    for (int i = t; i <= n && step(ratio, at(chain.from_camera, i), at(chain.from_light, i), i + 1);) ++i;
    ratio = 1;
    for (int i = t - 1; i >= 1 && step(ratio, at(chain.from_light, i), at(chain.from_camera, i), i);) --i;
    return 1 / sum;
}

}  // namespace plumb
