// Weights of all strategies of bidirectional tracing, on paths that it made: they sum to 1, and are those that products
// of densities give, recomputed from the positions of the path's vertices alone.

#include <set>

#include "integrators/path_classes.h"
#include "verification/deterministic.h"
#include "verification/suites/rendering/transport_subjects.h"
#include "verification/suites/suites.h"

namespace plumb {
namespace {

constexpr int longest = 8;

// Hears of every path that contributes, before what is in the way of connections is known.
void for_each_path(const Scene& scene, std::uint32_t samples,
                   const std::function<void(const PathChain&, int t)>& hear) {
    Bdpt bdpt({.max_edges = longest, .roulette_edges = longest});
    bdpt.weight = [&](const PathChain& chain, int t) {
        hear(chain, t);
        return 0.0;
    };
    PathRecord record;
    IndependentSamples numbers;
    for (std::uint32_t i = 0; i < samples; ++i) {
        numbers.start({7, 0, i});
        bdpt.trace(scene, whole_film(scene), numbers, record);
    }
}

// ln p_t of every strategy, −∞ where it cannot make the path: from scratch, for a path without mirrors.
std::vector<double> log_densities(const Scene& scene, const PathChain& chain) {
    const auto& z = chain.vertices;
    const std::size_t n = z.size() - 1;
    std::vector<double> from_camera(n + 1), from_light(n + 1), densities(n + 2, -HUGE_VAL);
    for (std::size_t i = 1; i <= n; ++i)
        from_camera[i] = density_onwards(scene, i >= 2 ? z[i - 2] : nullptr, *z[i - 1], *z[i], per_area);
    from_light[n] = density_of_origin(scene, *z[n], *z[n - 1]);
    for (std::size_t i = n; i-- > 1;)
        from_light[i] = density_onwards(scene, i + 2 <= n ? z[i + 2] : nullptr, *z[i + 1], *z[i], per_area);
    for (std::size_t t = 1; t <= n + 1; ++t) {
        if (!can_make(chain, static_cast<int>(t))) continue;
        densities[t] = 0;
        for (std::size_t i = 1; i <= n; ++i) densities[t] += std::log(i < t ? from_camera[i] : from_light[i]);
    }
    if (n >= 2 && can_make(chain, static_cast<int>(n)))
        densities[n] += std::log(density_of_choice(scene, *z[n], *z[n - 1], per_area) / from_light[n]);
    return densities;
}

double power_weight(const std::vector<double>& log_densities, std::size_t t) {
    double sum = 0;
    for (const double other : log_densities) sum += std::exp(2 * (other - log_densities[t]));
    return 1 / sum;
}

const std::vector<std::pair<std::string, const Scene& (*)()>>& scenes() {
    static const std::vector<std::pair<std::string, const Scene& (*)()>> list{{"box", box_scene},
                                                                              {"rough", rough_scene},
                                                                              {"caustic", caustic_scene},
                                                                              {"plates", plates_scene},
                                                                              {"sphere", glowing_sphere},
                                                                              {"point", sphere_around_point},
                                                                              {"smooth", smooth_normals_scene}};
    return list;
}

using Weight = double (*)(const PathChain&, int t);

Verdict weights_sum_to_one(Weight weight, const Run& run) {
    std::vector<BoundedCase> cases;
    for (const auto& [name, scene] : scenes()) {
        run.end_if_stopped();
        for_each_path(scene(), run.pick(40u, 2000u), [&, &scene_name = name](const PathChain& chain, int made_by) {
            double sum = 0;
            for (int t = 1; t <= chain.edges() + 1; ++t)
                if (can_make(chain, t)) sum += weight(chain, t);
            cases.push_back({fmt::format("{}, {} edges, made with t = {}", scene_name, chain.edges(), made_by),
                             std::abs(sum - 1), static_cast<double>(chain.edges())});
        });
    }
    return within_bound(cases, 1e-9, "of 1");
}

// Floats of rays move directions by 2^-24, and densities near grazing incidence by more.
Verdict weights_are_of_densities(Weight weight, const Run& run) {
    std::vector<BoundedCase> cases;
    for (const auto& [name, scene] : scenes()) {
        run.end_if_stopped();
        for_each_path(scene(), run.pick(40u, 2000u), [&, &scene_name = name](const PathChain& chain, int made_by) {
            if (std::ranges::count(chain.discrete, char{1})) return;
            const double truth = power_weight(log_densities(scene(), chain), static_cast<std::size_t>(made_by));
            cases.push_back({fmt::format("{}, {} edges, made with t = {}", scene_name, chain.edges(), made_by),
                             std::abs(weight(chain, made_by) - truth), static_cast<double>(chain.edges())});
        });
    }
    return within_bound(cases, 2e-3, "absolute");
}

double of_wrong_vertex(const PathChain& chain, int t) {
    PathChain other = chain;
    const auto i = static_cast<std::size_t>(t);
    if (i + 1 < other.from_camera.size()) other.from_camera[i] = chain.from_camera[i + 1];
    return strategy_weight(other, t);
}
double mirrors_ignored(const PathChain& chain, int t) {
    PathChain other = chain;
    std::ranges::fill(other.discrete, char{0});
    return strategy_weight(other, t);
}
double choice_ignored(const PathChain& chain, int t) {
    PathChain other = chain;
    other.choice = chain.from_light.back();
    return strategy_weight(other, t);
}

// ---- path classes

using Source = PathClass::Source;
using Classes = std::set<PathClass>;
using Predicate = bool (*)(Transporter, const PathClass&);

constexpr int most_edges = 5;

PathClass class_of(std::span<const PathVertex> vertices, Source source) {
    PathClass path{{}, source};
    for (const PathVertex& vertex : vertices) path.mirrors.push_back(!vertex.bsdf.smooth());
    return path;
}

// Of the splats of `path` and `light`, and of the strategies of `bdpt`, in a scene of pure materials.
Classes counted(Transporter transporter, Source source, std::uint32_t samples) {
    const Scene& scene = glass_scene(source);
    const PathLimits limits{.max_edges = most_edges, .roulette_edges = most_edges};
    Classes classes;
    Bdpt bdpt(limits);
    bdpt.weight = [&](const PathChain& chain, int) {
        PathClass path{{}, source};
        for (int i = 1; i < chain.edges(); ++i)
            path.mirrors.push_back(!chain.vertices[static_cast<std::size_t>(i)]->surface->bsdf.smooth());
        classes.insert(path);
        return 1.0;
    };
    const PathTracer path(limits);
    const LightTracer light(limits);
    const PathEstimator& estimator = transporter == Transporter::path    ? static_cast<const PathEstimator&>(path)
                                     : transporter == Transporter::light ? static_cast<const PathEstimator&>(light)
                                                                         : bdpt;
    PathRecord record;
    IndependentSamples numbers;
    for (std::uint32_t i = 0; i < samples; ++i) {
        numbers.start({11, 0, i});
        estimator.trace(scene, whole_film(scene), numbers, record);
        if (transporter == Transporter::bdpt) continue;
        for (const Splat& splat : record.splats) {
            const auto between = static_cast<std::size_t>(splat.edges - 1);
            PathClass one =
                class_of({(splat.anywhere ? record.light_vertices : record.vertices).data(), between}, source);
            if (splat.anywhere) std::ranges::reverse(one.mirrors);
            classes.insert(one);
        }
    }
    return classes;
}

// What any integrator found light on exists in the scene; of that, each must find what the predicate says, and no more.
Verdict classes_are(Predicate predicate, const Run& run) {
    constexpr std::array all{Transporter::path, Transporter::light, Transporter::bdpt};
    constexpr std::array<const char*, 3> names{"path", "light", "bdpt"};
    const auto samples = run.pick(6000u, 100'000u);
    std::uint64_t cases = 0;
    for (const Source source : {Source::surface, Source::point, Source::environment}) {
        run.end_if_stopped();
        std::array<Classes, 3> found;
        Classes exist;
        for (std::size_t i = 0; i < all.size(); ++i) {
            found[i] = counted(all[i], source, samples);
            exist.insert(found[i].begin(), found[i].end());
        }
        std::size_t listed = 0;
        for (int edges = 1; edges <= most_edges; ++edges)
            for (const PathClass& path : path_classes(glass_scene(source), edges)) listed += exist.contains(path);
        if (listed != exist.size())
            return exactly(false, cases, fmt::format("{} classes found, {} of them listed", exist.size(), listed));
        for (const PathClass& path : exist)
            for (std::size_t i = 0; i < all.size(); ++i, ++cases)
                if (found[i].contains(path) != predicate(all[i], path))
                    return exactly(false, cases,
                                   fmt::format("{} by {}: {}, predicted otherwise", to_string(path), names[i],
                                               found[i].contains(path) ? "made" : "not made"));
    }
    return exactly(true, cases, fmt::format("{} pairs of integrator and class", cases));
}

bool predicted(Transporter transporter, const PathClass& path) {
    return can_make(transporter, path);
}
bool lens_sees_mirrors(Transporter transporter, const PathClass& path) {
    return transporter == Transporter::light ? path.source != Source::point || !path.mirrors.empty()
                                             : can_make(transporter, path);
}
bool no_caustics_of_points(Transporter transporter, const PathClass& path) {
    return can_make(transporter == Transporter::bdpt ? Transporter::path : transporter, path);
}

}  // namespace

void add_transport_weight_claims(Catalogue& catalogue) {
    catalogue.add({.id = "render/bdpt/weights-sum",
                   .statement = "The weights of all strategies that can make a path of up to 8 edges sum to 1.",
                   .source = "[Veach 1997, section 9.2]",
                   .kind = Kind::bounded,
                   .check = [](const Run& run) { return weights_sum_to_one(strategy_weight, run); },
                   .mutants = {{"wrong-vertex", "The density of the next vertex in place of the connected one's.",
                                [](const Run& run) { return weights_sum_to_one(of_wrong_vertex, run); }},
                               {"mirror-connected", "Connections to mirrors count as if they could be made.",
                                [](const Run& run) { return weights_sum_to_one(mirrors_ignored, run); }}}});
    catalogue.add({.id = "render/bdpt/weights-densities",
                   .statement = "Weights are those of the products of densities, recomputed from vertices' positions.",
                   .source = "[Veach 1997, eq. 9.13 and section 10.2]",
                   .kind = Kind::bounded,
                   .check = [](const Run& run) { return weights_are_of_densities(strategy_weight, run); },
                   .mutants = {{"choice-ignored", "Lights are taken to be sampled as their subpaths begin.",
                                [](const Run& run) { return weights_are_of_densities(choice_ignored, run); }},
                               {"wrong-vertex", "The density of the next vertex in place of the connected one's.",
                                [](const Run& run) { return weights_are_of_densities(of_wrong_vertex, run); }}}});
    catalogue.add({.id = "render/path-classes/predicate",
                   .statement = "`path`, `light` and `bdpt` make the classes of paths that the predicate says.",
                   .source = "ours, integrators/path_classes.h",
                   .kind = Kind::exact,
                   .check = [](const Run& run) { return classes_are(predicted, run); },
                   .mutants = {{"lens-sees-mirrors", "`light` connects mirrors to the lens.",
                                [](const Run& run) { return classes_are(lens_sees_mirrors, run); }},
                               {"no-caustics-of-points", "`bdpt` makes no more than `path`.",
                                [](const Run& run) { return classes_are(no_caustics_of_points, run); }}}});
}

}  // namespace plumb
