// Light and bidirectional tracing against closed forms. Inside of a diffuse sphere of albedo ρ everything is as bright
// as everything else: light of emission L_e after k − 1 reflections is L_e ρ^(k−1), that of a point of intensity I at
// the centre, E = I/R² everywhere, is E ρ^(k−1)/π for k ≥ 2 edges.

#include "integrators/render.h"
#include "scenes/warps.h"
#include "verification/deterministic.h"
#include "verification/mean.h"
#include "verification/suites/rendering/transport_subjects.h"
#include "verification/suites/suites.h"

namespace plumb {
namespace {

constexpr int longest = 5;

PathLimits limits() {
    return {.max_edges = longest, .roulette_edges = 3};
}

using Made = std::shared_ptr<const PathEstimator>;

// Of each length; the sums 1 − 2^−D of the depth limits follow.
Verdict lengths_are(const Scene& scene, const Made& estimator, int shortest, const Run& run) {
    std::vector<Verdict> parts;
    for (int k = shortest; k <= longest; ++k) {
        const double reference = std::pow(0.5, shortest == 1 ? k : k - 1);
        const RegionMean mean{scene, *estimator, whole_film(scene), 16, k};
        parts.push_back(mean_is([&](RandomStream& random) { return mean.draw(random); },
                                {.reference = reference, .delta = run.pick(0.03, 0.005) * reference, .epsilon = 2e-6},
                                run.part(fmt::format("{}", k), 1.0 / longest)));
    }
    return all_of(std::move(parts));
}

// Of all lengths together, as a picture: 1 − 2^−D.
Verdict picture_is(const Made& estimator, const Run& run) {
    const Scene& scene = sphere_around_point();
    const double reference = 1 - std::pow(0.5, longest - 1);
    const auto draw = [&](RandomStream& random) {
        const RenderSettings settings{.samples_per_pass = 2, .passes = 1, .seed = random.bits(), .crop = {0, 0, 4, 4}};
        const Rendered rendered = render(scene, *estimator, settings);
        double sum = 0;
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) sum += rendered.film.mean(x, y, 0);
        return sum / 16;
    };
    return mean_is(draw, {.reference = reference, .delta = 0.03 * reference, .epsilon = 2e-6}, run);
}

template <class E>
Made made(const std::function<void(E&)>& change = {}) {
    E estimator(limits());
    if (change) change(estimator);
    return std::make_shared<E>(std::move(estimator));
}

// Splats as if the driver did not share them among the paths of a picture.
struct Unshared final : PathEstimator {
    Made estimator = made<LightTracer>();
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        estimator->trace(scene, region, samples, record);
        for (Splat& splat : record.splats)
            if (splat.anywhere) splat.value *= 16;
    }
};

std::optional<SensorSample> without_importance(const Scene& scene, Vec3 from, const Point<2>& lens) {
    auto sample = scene.sensor().connect(from, lens);
    if (sample) sample->importance = 1 / (sample->distance * sample->distance);
    return sample;
}
double without_cosine(const PathVertex& vertex, Vec3 wi) {
    return 1 / std::abs(dot(vertex.frame.z, wi));
}

struct Defect {
    std::string id, sentence;
    Made estimator;
};

void add_lengths(Catalogue& catalogue, const std::string& name, const std::string& title, const Scene& (*scene)(),
                 int shortest, const Made& estimator, const std::vector<Defect>& defects) {
    Claim claim{
        .id = "render/" + name,
        .statement = title,
        .source = "ours, verification/suites/rendering/transport_closed.cpp",
        .kind = Kind::mean,
        .check = [=](const Run& run) { return lengths_are(scene(), estimator, shortest, run); },
    };
    for (const Defect& defect : defects)
        claim.mutants.push_back({defect.id, defect.sentence, [=](const Run& run) {
                                     return lengths_are(scene(), defect.estimator, shortest, run);
                                 }});
    catalogue.add(std::move(claim));
}

StrategyWeight of_wrong_vertex() {
    return [](const PathChain& chain, int t) {
        PathChain other = chain;
        const auto i = static_cast<std::size_t>(t);
        if (i + 1 < other.from_camera.size()) other.from_camera[i] = chain.from_camera[i + 1];
        return strategy_weight(other, t);
    };
}

}  // namespace

void add_transport_closed_claims(Catalogue& catalogue) {
    const std::vector<Defect> of_light{
        {"without-importance", "The sensor's importance is left out at connections.",
         made<LightTracer>([](LightTracer& tracer) { tracer.connection = without_importance; })},
        {"one-cosine", "The cosine at the vertex that is connected to the lens is left out.",
         made<LightTracer>([](LightTracer& tracer) { tracer.correction = without_cosine; })}};
    const std::vector<Defect> of_bdpt{
        {"one-cosine", "The cosine at the light's end of connections is left out.",
         made<Bdpt>([](Bdpt& bdpt) { bdpt.rules.correction = without_cosine; })},
        {"inverted-jacobian", "Connections are multiplied by d² instead of 1/d².", made<Bdpt>([](Bdpt& bdpt) {
             bdpt.rules.falloff = [](const SubpathVertex& x, const SubpathVertex& y) { return 1 / falloff(x, y); };
         })},
        {"wrong-vertex", "The weight takes the density of the next vertex in place of that of the connected one.",
         made<Bdpt>([](Bdpt& bdpt) { bdpt.weight = of_wrong_vertex(); })},
        {"strategy-left-out", "Strategy (2, 2) is left out.", made<Bdpt>([](Bdpt& bdpt) {
             bdpt.weight = [](const PathChain& chain, int t) {
                 return t == 2 && chain.edges() == 3 ? 0 : strategy_weight(chain, t);
             };
         })}};
    add_lengths(catalogue, "light/glowing-sphere",
                "By light tracing, paths of k edges within a sphere of albedo ½ that emits ½ bring 2^-k.",
                glowing_sphere, 1, made<LightTracer>(), of_light);
    add_lengths(catalogue, "light/sphere-around-point",
                "By light tracing, paths of k edges within a sphere of albedo ½ around a point bring 2^(1-k).",
                sphere_around_point, 2, made<LightTracer>(), of_light);
    add_lengths(catalogue, "bdpt/glowing-sphere",
                "By bidirectional tracing, paths of k edges within a sphere of albedo ½ that emits ½ bring 2^-k.",
                glowing_sphere, 1, made<Bdpt>(), of_bdpt);
    add_lengths(catalogue, "bdpt/sphere-around-point",
                "By bidirectional tracing, paths of k edges within a sphere of albedo ½ around a point bring 2^(1-k).",
                sphere_around_point, 2, made<Bdpt>(), of_bdpt);
    catalogue.add({.id = "render/light/picture",
                   .statement = "A picture by light tracing shares its light paths among its pixels.",
                   .source = "ours, integrators/render.cpp",
                   .kind = Kind::mean,
                   .check = [](const Run& run) { return picture_is(made<LightTracer>(), run); },
                   .mutants = {{"unshared", "Splats are not divided by the number of light paths.",
                                [](const Run& run) { return picture_is(std::make_shared<Unshared>(), run); }}}});
}

}  // namespace plumb
