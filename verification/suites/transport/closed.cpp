// Path, light and bidirectional tracing against closed forms. Inside of a diffuse sphere of albedo ρ everything is as
// bright as everything else: light of emission L_e after k − 1 reflections is L_e ρ^(k−1), that of a point of intensity
// I at the centre, E = I/R² everywhere, is E ρ^(k−1)/π for k ≥ 2 edges.

#include "estimators/densities/warps.h"
#include "integrators/drivers/render.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

constexpr int longest = 4;

PathLimits limits() {
    return {.max_edges = longest, .roulette_edges = 3};
}

struct Sphere {
    const Scene& (*scene)();
    double first;  ///< paths of k edges, k ≥ 2, bring first · 2^-k
};
constexpr Sphere glowing{glowing_sphere, 1}, around_point{sphere_around_point, 2};

/// The relative precision to which an integrator is held; `constant`: every path of it is what it should be.
struct Precision {
    double quick, full;
    bool constant = false;
};

using Made = std::shared_ptr<const PathEstimator>;

std::uint64_t cap(const Run& run) {
    return run.pick(std::uint64_t{1} << 16, std::uint64_t{1} << 21);
}

// The sums 1 − 2^-D of limited depths follow.
Verdict lengths_are(const Sphere& sphere, const PathEstimator& estimator, const Precision& precision, const Run& run) {
    const Scene& scene = sphere.scene();
    std::vector<Verdict> parts;
    for (int k = 2; k <= longest; ++k) {
        const double reference = sphere.first * std::pow(0.5, k);
        const RegionMean mean{scene, estimator, whole_film(scene), 16, k};
        parts.push_back(mean_is([&](RandomStream& random) { return mean.draw(random); },
                                {.reference = reference,
                                 .delta = run.pick(precision.quick, precision.full) * reference,
                                 .epsilon = 1e-5 * reference,
                                 .why_fewer = "closed: every path goes on and brings light",
                                 .cap = precision.constant ? std::uint64_t{256} : cap(run),
                                 .zero_variance = precision.constant},
                                run.part(fmt::format("{}", k), 1.0 / (longest - 1))));
    }
    return all_of(std::move(parts));
}

// The verdict on a picture of all lengths together: 1 − 2^−D.
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
    return mean_is(draw,
                   {.reference = reference,
                    .delta = 0.03 * reference,
                    .epsilon = 2e-6,
                    .why_fewer = "closed: every path goes on and brings light",
                    .cap = cap(run)},
                   run);
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
using Defect = Wrong<Made>;

void add_lengths(Catalogue& catalogue, const std::string& name, const std::string& title, const Sphere& sphere,
                 const Precision& precision, const Made& estimator, const std::vector<Defect>& defects) {
    const auto check = [=](const Made& subject, const Run& run) {
        return lengths_are(sphere, *subject, precision, run);
    };
    catalogue.add({
        .id = "render/" + name,
        .statement = title,
        .source = "ours, verification/suites/transport/closed.cpp",
        .kind = Kind::mean,
        .trial = {check, estimator, defects},
    });
}

// A light's path lands on a pixel of the film once in five times; one from the camera always meets light.
constexpr Precision coarse{0.05, 0.005}, fine{0.005, 0.001}, exact{0.005, 0.001, true};

const std::string own_light = "paths of k edges within a sphere of albedo ½ that emits ½ bring 2^-k.";
const std::string of_point = "paths of k edges within a sphere of albedo ½ around a point bring 2^(1-k).";

void add_path(Catalogue& catalogue) {
    const auto tracer = [](int max_edges, MisWeight weight = mis_weight<Power>) {
        auto path = std::make_shared<PathTracer>(PathLimits{.max_edges = max_edges, .roulette_edges = longest});
        path->next_event.weight = weight;
        return path;
    };
    add_lengths(
        catalogue, "path/glowing-sphere", "By path tracing, " + own_light, glowing, fine, tracer(longest),
        {{"met-twice", "Light that is met counts in full beside the lights' samples.", tracer(longest, in_full)}});
    add_lengths(catalogue, "path/sphere-around-point", "By path tracing, " + of_point, around_point, exact,
                tracer(longest), {{"one-edge-less", "Paths end behind one edge less.", tracer(longest - 1)}});
}

void add_light(Catalogue& catalogue) {
    const std::vector<Defect> defects{
        {"without-importance", "The sensor's importance is left out at connections.",
         made<LightTracer>([](LightTracer& tracer) { tracer.connection = without_importance; })}};
    add_lengths(catalogue, "light/glowing-sphere", "By light tracing, " + own_light, glowing, coarse,
                made<LightTracer>(), defects);
    add_lengths(catalogue, "light/sphere-around-point", "By light tracing, " + of_point, around_point, coarse,
                made<LightTracer>(), defects);
    catalogue.add({.id = "render/light/picture",
                   .statement = "A picture by light tracing shares its light paths among its pixels.",
                   .source = "ours, integrators/drivers/render.cpp",
                   .kind = Kind::mean,
                   .trial = {picture_is,
                             made<LightTracer>(),
                             {{"unshared", "Splats are not divided by the number of light paths.",
                               std::make_shared<Unshared>()}}}});
}

void add_bdpt(Catalogue& catalogue) {
    const std::vector<Defect> defects{
        {"inverted-jacobian", "Connections are multiplied by d² instead of 1/d².", made<Bdpt>([](Bdpt& bdpt) {
             bdpt.rules.falloff = [](const SubpathVertex& x, const SubpathVertex& y) { return 1 / falloff(x, y); };
         })},
        {"wrong-vertex", "The weight takes the density of the next vertex in place of that of the connected one.",
         made<Bdpt>([](Bdpt& bdpt) { bdpt.weight = weight_of_wrong_vertex; })},
        {"strategy-left-out", "Strategy (2, 2) is left out.", made<Bdpt>([](Bdpt& bdpt) {
             bdpt.weight = [](const PathChain& chain, int t) {
                 return t == 2 && chain.edges() == 3 ? 0 : strategy_weight(chain, t);
             };
         })}};
    add_lengths(catalogue, "bdpt/glowing-sphere", "By bidirectional tracing, " + own_light, glowing, fine, made<Bdpt>(),
                defects);
    add_lengths(catalogue, "bdpt/sphere-around-point", "By bidirectional tracing, " + of_point, around_point, fine,
                made<Bdpt>(), {defects.back()});
}

}  // namespace

void add_transport_closed(Catalogue& catalogue) {
    add_path(catalogue);
    add_light(catalogue);
    add_bdpt(catalogue);
}

}  // namespace plumb::suites
