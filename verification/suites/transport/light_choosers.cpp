// Choices of lights and estimates of visibility that are wrong but positive: `direct`, `path` and `bdpt`, which share
// them, find the same light by any, and the weights of one direction by all techniques sum to 1.

#include "integrators/paths/vertex.h"
#include "verification/evidence/mean.h"
#include "verification/suites/suites.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

using Made = std::shared_ptr<const PathEstimator>;
using Choice = std::shared_ptr<const LightChoice>;

/// Prefers the first light on one side of the scene, the last on the other, 5 to 1.
struct BySide final : ChoiceByProbability {
    [[nodiscard]] ChosenLight choose(const Scene& scene, const SurfacePoint& from, double u) const override {
        std::size_t light = 0;
        double below = pmf(scene, from, 0);
        while (u >= below && light + 1 < scene.lights().size()) below += pmf(scene, from, ++light);
        return {light, pmf(scene, from, light)};
    }
    [[nodiscard]] double pmf(const Scene& scene, const SurfacePoint& from, std::size_t light) const override {
        const std::size_t count = scene.lights().size(), preferred = from.position.x < 0 ? 0 : count - 1;
        return (light == preferred ? 5.0 : 1.0) / (static_cast<double>(count) + 4);
    }
};

/// Samples by one choice, and claims the density of another.
struct Misquoted final : LightChoice {
    Choice sampled, quoted;
    Misquoted(Choice s, Choice q) : sampled(std::move(s)), quoted(std::move(q)) {}
    [[nodiscard]] std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                         SampleIndex index, Draws& draws) const override {
        return sampled->sample(scene, from, index, draws);
    }
    [[nodiscard]] double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const override {
        return quoted->pdf(scene, from, point);
    }
};

/// Samples by one choice, and divides by the density of another.
struct Misdivided final : LightChoice {
    Choice sampled, divisor;
    Misdivided(Choice s, Choice d) : sampled(std::move(s)), divisor(std::move(d)) {}
    [[nodiscard]] std::optional<SceneLightSample> sample(const Scene& scene, const SurfacePoint& from,
                                                         SampleIndex index, Draws& draws) const override {
        auto light = sampled->sample(scene, from, index, draws);
        if (light) light->pdf = divisor->pdf(scene, from, light_point(*light));
        return light;
    }
    [[nodiscard]] double pdf(const Scene& scene, const SurfacePoint& from, const LightPoint& point) const override {
        return divisor->pdf(scene, from, point);
    }
};

/// Traces a shadow ray with a probability of 0.4 to 0.8 by position, and divides by it.
struct RandomShadowRays final : Visibility {
    bool divided;
    explicit RandomShadowRays(bool d) : divided(d) {}
    [[nodiscard]] double sample(const Scene& scene, const SurfacePoint& from, const LightSample& end, SampleIndex index,
                                Draws& draws, RayLog& rays) const override {
        const double survives = 0.6 + 0.2 * std::sin(3 * from.position.x + 5 * from.position.y);
        if (draws.at(index.slot(Use::visibility))[0] >= survives) return 0;
        return scene.transmittance(from, end, rays) / (divided ? survives : 0.8);
    }
};

// ---- means

struct Parts {
    Choice choice = choice_by_power();
    std::shared_ptr<const Visibility> visibility = shadow_rays();
};
constexpr PathLimits limits{.max_edges = 4, .roulette_edges = 3};

NextEvent next_event_of(const Parts& parts) {
    NextEvent next_event;
    next_event.lights = {{parts.choice}};
    next_event.visibility = parts.visibility;
    return next_event;
}
Made direct_by(const Parts& parts) {
    return std::make_shared<Direct>(next_event_of(parts));
}
Made path_by(const Parts& parts) {
    auto path = std::make_shared<PathTracer>(limits);
    path->next_event = next_event_of(parts);
    return path;
}
Made bdpt_by(const Parts& parts) {
    auto bdpt = std::make_shared<Bdpt>(limits);
    bdpt->choice = parts.choice;
    bdpt->visibility = parts.visibility;
    return bdpt;
}

struct Integrator {
    std::string name;
    Made (*by)(const Parts&);
    double mean;  ///< of the film, lights seen directly left out: the unit of δ
};
const std::vector<Integrator>& all_integrators() {
    static const std::vector<Integrator> list{
        {"direct", direct_by, 0.3}, {"path", path_by, 0.35}, {"bdpt", bdpt_by, 0.35}};
    return list;
}

Verdict as_usual(const Integrator& integrator, const Made& other, double share, const Run& run) {
    const Scene& scene = lamps_scene();
    const Made usual = integrator.by({});
    const RegionMean a{scene, *usual, whole_film(scene)}, b{scene, *other, whole_film(scene)};
    return same_mean(a, b,
                     {.delta = run.pick(0.01, 0.0025) * integrator.mean,
                      .epsilon = 1e-5 * integrator.mean,
                      .why_fewer = "a path in every pixel of the film: each lamp is chosen by many",
                      .cap = run.pick(std::uint64_t{1} << 17, std::uint64_t{1} << 21)},
                     run.part("mean", share));
}

void add_choices(Catalogue& catalogue, const Integrator& integrator) {
    const auto check = [integrator](const std::vector<Choice>& choices, const Run& run) {
        std::vector<Verdict> parts;
        for (const Choice& choice : choices)
            parts.push_back(
                as_usual(integrator, integrator.by({.choice = choice}), 1,
                         run.part(fmt::format("{}", parts.size()), 1 / static_cast<double>(choices.size()))));
        return all_of(std::move(parts));
    };
    using Choices = std::vector<Choice>;
    const auto by_side = std::make_shared<BySide>();
    Choices choices{by_side};
    for (const NamedLightChoice& named : light_choices())
        if (named.id != "power") choices.push_back(named.make());
    std::vector<Wrong<Choices>> wrong{{"divided-by-power", "Samples are divided by the density of the choice by power.",
                                       Choices{std::make_shared<Misdivided>(by_side, choice_by_power())}}};
    // The weights of `bdpt` are functions of the path alone: by whatever choice's density, they sum to 1.
    if (integrator.name != "bdpt")
        wrong.push_back({"weighted-by-power", "Light that is met is weighted as if lights were chosen by power.",
                         Choices{std::make_shared<Misquoted>(by_side, choice_by_power())}});
    catalogue.add({
        .id = fmt::format("render/{}/light-choice/lamps", integrator.name),
        .statement = fmt::format("`{}` finds the same light of two lamps and a sky by any positive choice of lights.",
                                 integrator.name),
        .source = "[Veach & Guibas 1995]",
        .kind = Kind::mean,
        .trial = {check, choices, std::move(wrong)},
    });
}

void add_visibility(Catalogue& catalogue, const Integrator& integrator) {
    const auto check = [integrator](bool divided, const Run& run) {
        return as_usual(integrator, integrator.by({.visibility = std::make_shared<RandomShadowRays>(divided)}), 1, run);
    };
    catalogue.add(
        {.id = fmt::format("render/{}/random-visibility/lamps", integrator.name),
         .statement = fmt::format("By shadow rays that are traced at random, and divided by their probability, `{}` "
                                  "finds the same light.",
                                  integrator.name),
         .source = "ours, integrators/paths/next_event/visibility.h",
         .kind = Kind::mean,
         .trial = {
             check,
             true,
             {{"not-divided", "What is not hidden is divided by the largest probability, not its own.", false}}}});
}

// ---- weights of one direction

// A light point that a choice found, met again by a ray, has its density where the ray ends: off by the ray's miss m
// across itself, hence by m tan θ along, θ being the angle to the light's normal. All choices see it as d²/cos θ with
// factors of their own, and cos θ is that of the direction, which both share. So ln p changes alike for all, by at most
// 2 m tan θ/d and second order, and a weight p_0²/Σp² by 2w(1 − w) ≤ ½ of that. An environment's density depends on the
// direction alone.
double change_of_weight(const SurfacePoint& from, const LightSample& sample) {
    if (!sample.surface) return 0;
    const double cosine = std::abs(dot(sample.surface->normal, sample.direction));
    const double miss = ray_miss(from, *sample.surface) / sample.distance;
    return 1.01 * miss * std::sqrt(1 / (cosine * cosine) - 1) + miss * miss;
}

/// A vertex at a time: a light point that the choice found, met again by a ray of that direction.
Verdict weights_sum_to_one(const std::vector<Choice>& choices, const Run& run) {
    const Scene& scene = lamps_scene();
    HeldCases cases;
    NextEvent next_event;
    next_event.lights.clear();
    int count = 1;
    for (const Choice& choice : choices) next_event.lights.push_back({choice, count++});
    next_event.bsdf_count = 3;
    PathRecord record;
    IndependentSamples numbers;
    for (std::uint32_t i = 0; i < run.pick(4000u, 100'000u); ++i) {
        numbers.start({run.random(0).bits(), 0, i});
        Draws draws(numbers);
        const CameraStart start = start_at_camera(scene, whole_film(scene), draws);
        const auto vertex = trace_to_vertex(scene, start.ray, 1, draws, record);
        if (!vertex) continue;
        const std::size_t k = i % choices.size();
        const auto light = choices[k]->sample(scene, vertex->hit.point, {1}, draws);
        if (!light || is_black(eval_bsdf(*vertex, light->sample.direction, Transport::radiance))) continue;
        const Vec3 wi = light->sample.direction;
        const auto hit = trace_to_hit(scene, leave(vertex->hit.point, wi), {2}, draws, record);
        if (hit ? scene.light_of(*hit) != light->light : scene.environment_light() != light->light) continue;
        const double bsdf_pdf = vertex->bsdf.pdf(vertex->to_local(vertex->wo), vertex->to_local(wi));
        if (!(bsdf_pdf > 0)) continue;
        // Each technique as if it had found the direction: choices by their samples' density, the BSDF by what it met.
        double sum = weight_of_bsdf(next_event, scene, *vertex, light_point(scene, hit, wi), bsdf_pdf).weight;
        for (std::size_t j = 0; j < choices.size(); ++j) {
            const LightPoint point = light_point(*light);
            const double pdf = j == k ? light->pdf : choices[j]->pdf(scene, vertex->hit.point, point);
            sum += weight_of_choice(next_event, scene, *vertex, point, j, pdf).weight;
        }
        constexpr double of_doubles = 1e-12;
        cases.add(fmt::format("sample {}", i), std::abs(sum - 1),
                  change_of_weight(vertex->hit.point, light->sample) + of_doubles);
    }
    return cases.verdict();
}

void add_weights(Catalogue& catalogue) {
    using Choices = std::vector<Choice>;
    const auto by_side = std::make_shared<BySide>();
    catalogue.add({.id = "render/next-event/weights-sum",
                   .statement =
                       "The weights of one direction by several choices of lights, with counts of their own, "
                       "and the BSDF sum to 1, within what the rounding of the ray that meets a light can change.",
                   .source = "[Veach 1997, eq. 9.4]",
                   .kind = Kind::bounded,
                   .trial = {weights_sum_to_one,
                             Choices{by_side, choice_by_power(), uniform_choice()},
                             {{"weighted-by-power", "One choice is weighted as if it chose by power.",
                               Choices{std::make_shared<Misquoted>(by_side, choice_by_power()), uniform_choice()}}}}});
}

}  // namespace

void add_transport_light_choosers(Catalogue& catalogue) {
    for (const Integrator& integrator : all_integrators()) {
        add_choices(catalogue, integrator);
        add_visibility(catalogue, integrator);
    }
    add_weights(catalogue);
}

}  // namespace plumb::suites
