// Path tracing alone: closed furnaces bounce by bounce, concentric spheres to all orders, lossless glass under a white
// sky, Russian roulette, the same numbers as `direct` where that is all there is, and replay from a key.

#include <numbers>

#include "integrators/drivers/sampler.h"
#include "integrators/estimators/path.h"
#include "integrators/paths/vertex.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

using Estimator = std::shared_ptr<const PathEstimator>;

constexpr int all_edges = 1 << 20;

// ---- estimators with a defect

Estimator paths(PathLimits limits = {}) {
    return std::make_shared<PathTracer>(limits);
}

Estimator paths_with(NextEvent next_event, PathLimits limits = {}) {
    auto tracer = std::make_shared<PathTracer>(limits);
    tracer->next_event = next_event;
    return tracer;
}

NextEvent counting_twice() {
    return with_weight(in_full);
}

NextEvent unweighted_light_density() {
    NextEvent next_event;
    next_event.weight = [](std::span<const double> densities, std::size_t own) {  // squared on one side
        const double p = densities[own], q = densities[1 - own];
        return p * p / (p * p + q);
    };
    return next_event;
}

// Steps of the library's path tracer without its roulette, and a roulette of our own between them.
struct OwnRoulette final : PathEstimator {
    PathTracer tracer{PathLimits{.roulette_edges = all_edges}};
    // The throughput of a path that goes on; empty where it ends.
    std::optional<Spectrum> (*play)(const PathState& before, const PathState& after, double u);

    explicit OwnRoulette(decltype(play) p) : play(p) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        record.clear();
        Draws draws(samples);
        const CameraStart start = start_at_camera(scene, region, draws);
        PathState state{.ray = start.ray, .direction = start.ray.direction};
        PathState before = state;
        while (tracer.step(scene, start.film, state, draws, record)) {
            const double u = draws.at({before.vertex, Use::roulette})[0];
            const auto throughput = play(before, state, u);
            if (!throughput) return;
            state.throughput = *throughput;
            before = state;
        }
    }
};

double chance(const PathState& state) {
    return survive_by_throughput(state.throughput, state.eta_squared);
}

std::optional<Spectrum> without_compensation(const PathState&, const PathState& after, double u) {
    return u < chance(after) ? std::optional(after.throughput) : std::nullopt;
}

// Decides by the throughput before the vertex, compensates by that behind it.
std::optional<Spectrum> of_two_vertices(const PathState& before, const PathState& after, double u) {
    return u < chance(before) ? std::optional(after.throughput / chance(after)) : std::nullopt;
}

// ---- closed furnaces

struct MeanOnScene {
    std::shared_ptr<const Scene> scene;
    Estimator estimator;
    double reference;
    double delta;
    bool constant = false;  ///< nothing is left to chance
};

Verdict mean_on_scene(const MeanOnScene& subject, const Run& run) {
    const FilmSize film = subject.scene->sensor().film();
    const Measurement measurement{*subject.scene, *subject.estimator, {}, {0, 0, film.width, film.height}, 16,
                                  all_edges};
    return mean_is([&](RandomStream& random) { return luminance(measurement.draw(random)); },
                   {.reference = subject.reference,
                    .delta = subject.delta,
                    .epsilon = 1e-5 * subject.reference,
                    .why_fewer = "sixteen paths in a scene that glows all over",
                    .cap = subject.constant ? std::uint64_t{256} : std::uint64_t{1} << 20,
                    .zero_variance = subject.constant},
                   run);
}

std::shared_ptr<const Scene> shipped(const std::string& name) {
    return std::make_shared<const Scene>(load_mitsuba(scene_file(name)));
}

void add_furnace(Catalogue& catalogue) {
    const auto check = [](double truth) {
        return [=](const Estimator& estimator, const Run& run) {
            return mean_on_scene({shipped("furnace_box"), estimator, truth, run.pick(5e-3, 1e-3) * truth, truth == 1},
                                 run);
        };
    };
    for (int edges = 1; edges <= 4; ++edges) {
        const double truth = 2 - std::pow(0.5, edges - 1);
        std::vector<Wrong<Estimator>> wrong{
            {"one-edge-more", "Paths of one edge more are counted too.", paths({.max_edges = edges + 1})}};
        // Light that is met in full would have no finite variance here: the mutant of it is beside two spheres.
        if (edges > 1)
            wrong.push_back({"mis-squared-on-one-side", "The heuristic squares one of the two densities.",
                             paths_with(unweighted_light_density(), {.max_edges = edges})});
        catalogue.add({.id = fmt::format("render/path/furnace-{}", edges),
                       .statement = fmt::format("In a closed box of albedo ½ that shines everywhere, paths of at most "
                                                "{} edges see 1 + ½ + … = {}.",
                                                edges, truth),
                       .source = "geometric series; scenes/shipped/furnace_box/expected.json",
                       .kind = Kind::mean,
                       .trial = {check(truth), paths({.max_edges = edges}), std::move(wrong)}});
    }
    catalogue.add({.id = "render/path/furnace",
                   .statement = "In a closed box of albedo ½ that shines everywhere, L = Le/(1 − ρ) = 2.",
                   .source = "geometric series; scenes/shipped/furnace_box/expected.json",
                   .kind = Kind::mean,
                   .trial = {check(2),
                             paths(),
                             {{"ends-at-8", "Paths end behind 6 edges.", paths({.max_edges = 6})},
                              {"no-compensation", "What survives the roulette carries no more than before.",
                               std::make_shared<OwnRoulette>(without_compensation)},
                              {"mis-squared-on-one-side", "The heuristic squares one of the two densities.",
                               paths_with(unweighted_light_density())}}}});
}

// ---- a shining sphere within a reflecting one

// Outside sphere of radius R, albedo ρ, seen from inside; inside one of radius r, black, of radiance L. A point of the
// outside sphere sees the inside one with the form factor (r/R)², else the outside one: E = π L f + ρ E (1 − f), f =
// (r/R)², so that what it sends is ρ E/π = ρ f L/(1 − ρ (1 − f)).
constexpr double inner = 0.4, rho = 0.7, seen_share = inner * inner;

description::Scene spheres() {
    description::Scene scene;
    const auto white = add_material(scene, description::Diffuse{Spectrum::grey(rho)});
    const auto black = add_material(scene, description::Diffuse{Spectrum::grey(0)});
    add_shape(scene, description::Sphere{.center = {}, .radius = 1, .flip_normals = true, .to_world = {}}, white);
    add_shape(scene, description::Sphere{.center = {}, .radius = inner, .flip_normals = false, .to_world = {}}, black,
              Spectrum::grey(1));
    scene.sensor = camera({0, 0, 0.6}, {0.9, 0.1, 0.7}, 30, 8, 8);
    return scene;
}

void add_spheres(Catalogue& catalogue) {
    const double truth = rho * seen_share / (1 - rho * (1 - seen_share));
    const auto check = [=](const Estimator& estimator, const Run& run) {
        return mean_on_scene({std::make_shared<const Scene>(spheres()), estimator, truth, run.pick(5e-3, 1e-3) * truth},
                             run);
    };
    catalogue.add(
        {.id = "render/path/concentric-spheres",
         .statement = "A sphere that shines within a reflecting one: light of all orders is ρf/(1 − ρ(1 − f)) "
                      "with f the squared ratio of the radii.",
         .source = "ours, verification/suites/transport/path.cpp",
         .kind = Kind::mean,
         .trial = {check,
                   paths(),
                   {{"met-twice", "Light that is met counts in full beside the lights' samples.",
                     paths_with(counting_twice())},
                    {"ends-early", "Paths end behind 8 edges.", paths({.max_edges = 8})},
                    {"roulette-of-two-vertices", "The roulette decides by one vertex and compensates by the next.",
                     std::make_shared<OwnRoulette>(of_two_vertices)}}}});
}

// ---- lossless glass under a white sky

struct HalfScaled final : PathEstimator {
    // Radiance that is refracted towards the sensor keeps the factor of one side only.
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        PathTracer({.roulette_edges = all_edges}).trace(scene, region, samples, record);
        for (const PathVertex& vertex : record.vertices)
            if (dot(vertex.wo, vertex.hit.point.normal) < 0) {
                for (Splat& splat : record.splats) splat.value *= 1 / 2.25;
                break;
            }
    }
};

description::Scene glass_ball() {
    description::Scene scene;
    const auto glass = add_material(scene, description::Dielectric{.eta = 1.5, .roughness = {}});
    add_shape(scene, description::Sphere{.center = {}, .radius = 1, .flip_normals = false, .to_world = {}}, glass);
    scene.emitters.emplace_back().kind = description::ConstantSky{Spectrum::grey(1)};
    scene.sensor = camera({0, 0, 4}, {0, 0, 0}, 25, 8, 8);
    return scene;
}

void add_glass(Catalogue& catalogue) {
    const auto check = [](const Estimator& estimator, const Run& run) {
        return mean_on_scene({std::make_shared<const Scene>(glass_ball()), estimator, 1, 5e-3, true}, run);
    };
    catalogue.add(
        {.id = "render/path/glass",
         .statement = "A ball of smooth glass cannot be seen under a white sky: every path carries 1.",
         .source = "[Veach 1997, section 5.2]",
         .kind = Kind::mean,
         .trial = {
             check,
             paths({.roulette_edges = all_edges}),
             {{"one-side", "Radiance is scaled by η² on one of two sides.", std::make_shared<HalfScaled>()},
              {"ends-inside", "Paths end behind 3 edges.", paths({.max_edges = 3, .roulette_edges = all_edges})}}}});
}

// ---- direct light is path tracing of two edges

std::vector<std::string> small_scenes() {
    std::vector<std::string> names;
    for (const ShippedScene& scene : shipped_scenes())
        if (scene.name != "million_triangles") names.push_back(scene.name);  // loading it takes half a second
    return names;
}

Verdict equals_direct(const PathEstimator& path, const Run& run) {
    std::vector<BoundedCase> cases;
    for (const std::string& name : small_scenes()) {
        const auto scene = shipped(name);
        const FilmSize film = scene->sensor().film();
        PathRecord a, b;
        double worst = 0;
        for (std::uint32_t i = 0; i < 64; ++i) {
            IndependentSamples samples({run.random(0).bits(), 0, i});
            Direct().trace(*scene, {0, 0, film.width, film.height}, samples, a);
            path.trace(*scene, {0, 0, film.width, film.height}, samples, b);
            const Spectrum difference = a.sum() - b.sum();
            worst = std::max(worst, std::abs(luminance(difference)) / (1e-30 + luminance(a.sum())));
        }
        cases.push_back({name, worst});
    }
    return within_bound(cases, 1e-12, "relative");
}

void add_direct(Catalogue& catalogue) {
    const auto check = [](PathLimits limits, const Run& run) { return equals_direct(PathTracer(limits), run); };
    catalogue.add({.id = "render/path/two-edges",
                   .statement = "From the same numbers, path tracing of at most two edges is direct illumination.",
                   .source = "ours, integrators/estimators/path.cpp",
                   .kind = Kind::bounded,
                   .trial = {check,
                             {.max_edges = 2},
                             {{"three-edges", "Depth counts one less.", {.max_edges = 3}},
                              {"one-edge", "Depth counts one more.", {.max_edges = 1}}}}});
}

// ---- replay

using Replay = std::function<PrimarySamples&(Sampler&, const PathKey&)>;

bool same(const PathRecord& a, const PathRecord& b) {
    const auto equal = [](const Splat& x, const Splat& y) {
        return x.value == y.value && x.film == y.film && x.edges == y.edges;
    };
    return std::ranges::equal(a.splats, b.splats, equal) && a.vertices.size() == b.vertices.size();
}

Verdict replays(const Replay& replay, const Run& run) {
    const auto scene = shipped("glass");
    const PathTracer tracer;
    std::uint64_t different = 0, count = 0;
    for (const std::string name : {"independent", "stratified", "sobol"}) {
        Sampler first(name, 16), again(name, 16);
        const std::uint64_t seed = run.random(0).bits();
        for (std::uint32_t i = 0; i < 64; ++i, ++count) {
            // Whole samples are skipped, and one slot is asked for out of turn.
            const PathKey key{seed, 1000 + i % 7, i};
            PathRecord a, b;
            tracer.trace(*scene, {96, 72, 8, 8}, replay(first, key), a);
            PrimarySamples& samples = again.start(key);
            samples.at({3, Use::direction});
            tracer.trace(*scene, {96, 72, 8, 8}, samples, b);
            different += !same(a, b);
        }
    }
    return exactly(different == 0, count, fmt::format("{} of {} replayed paths differ", different, count));
}

void add_replay(Catalogue& catalogue) {
    catalogue.add({.id = "render/path/replay",
                   .statement = "A path's key gives the path again, bit by bit, with any sampler, whatever was asked "
                                "for before.",
                   .source = "ours, core/primary_samples.h",
                   .kind = Kind::exact,
                   .trial = {replays,
                             [](Sampler& sampler, const PathKey& key) -> PrimarySamples& { return sampler.start(key); },
                             {{"next-sample", "The key of the next sample is taken.",
                               [](Sampler& sampler, const PathKey& key) -> PrimarySamples& {
                                   return sampler.start({key.seed, key.pixel, key.sample + 1});
                               }},
                              {"no-pixel", "The key forgets its pixel.",
                               [](Sampler& sampler, const PathKey& key) -> PrimarySamples& {
                                   return sampler.start({key.seed, 0, key.sample});
                               }}}}});
}

}  // namespace

void add_transport_path(Catalogue& catalogue) {
    add_furnace(catalogue);
    add_spheres(catalogue);
    add_glass(catalogue);
    add_direct(catalogue);
    add_replay(catalogue);
}

}  // namespace plumb::suites
