// Weights of all strategies of bidirectional tracing, on paths that it made: they sum to 1, and are those that products
// of densities give, recomputed from the positions of the path's vertices alone.

#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

constexpr int longest = 8;

// Hears of every path that contributes, before what is in the way of connections is known.
void for_each_path(const Scene& scene, const Run& run, const std::function<void(const PathChain&, int t)>& hear) {
    Bdpt bdpt({.max_edges = longest, .roulette_edges = longest});
    bdpt.weight = [&](const PathChain& chain, int t) {
        hear(chain, t);
        return 0.0;
    };
    PathRecord record;
    IndependentSamples numbers;
    const std::uint64_t seed = run.random(0).bits();
    for (std::uint32_t i = 0; i < run.pick(40u, 2000u); ++i) {
        numbers.start({seed, 0, i});
        bdpt.trace(scene, whole_film(scene), numbers, record);
    }
}

// ---- densities from scratch, for a path without mirrors

double miss(const SubpathVertex& x, const SubpathVertex& y) {
    constexpr auto environment = SubpathVertex::Kind::environment;
    if (x.kind == environment || y.kind == environment) return ray_turn;
    return ray_miss(x.point, y.point);
}

// ln of what density_onwards says, per steradian, and by how much, to first order, it changes where the ends of its two
// edges miss.
struct LogDensity {
    double value = 0, error = 0;
};
LogDensity log_density(const Scene& scene, const SubpathVertex* before, const SubpathVertex& at,
                       const SubpathVertex& next) {
    const auto per_steradian = [](double pdf, const SubpathVertex&, const SubpathVertex&) { return pdf; };
    const auto value = [&](const SubpathVertex* from, const SubpathVertex& to) {
        return std::log(density_onwards(scene, from, at, to, per_steradian));
    };
    LogDensity density{std::log(density_onwards(scene, before, at, next, per_area))};
    const double undisturbed = value(before, next);
    for (const bool onwards : {false, true}) {
        if (!onwards && !before) continue;
        const SubpathVertex& end = onwards ? next : *before;
        const Frame across(at.towards(end));
        for (const Vec3 axis : {across.x, across.y}) {
            double most = 0;
            for (const double sign : {-1., 1.}) {
                SubpathVertex moved = end;
                moved.point.position += axis * (sign * miss(at, end));
                most = std::max(most, std::abs((onwards ? value(before, moved) : value(&moved, next)) - undisturbed));
            }
            density.error += most;
        }
    }
    return density;
}

// ln p_t of every strategy, −∞ where it cannot make the path.
struct Densities {
    std::vector<double> logs;
    std::vector<LogDensity> from_camera, from_light;

    // A bound of the error of ln p_i/p_j, by the vertices that only one strategy makes from the sensor.
    [[nodiscard]] double error_of_ratio(std::size_t i, std::size_t j) const {
        double sum = 0;
        for (std::size_t k = std::min(i, j); k < std::max(i, j); ++k) sum += from_camera[k].error + from_light[k].error;
        return sum;
    }
};
Densities densities_of(const Scene& scene, const PathChain& chain) {
    const auto& z = chain.vertices;
    const std::size_t n = z.size() - 1;
    Densities densities{std::vector<double>(n + 2, -HUGE_VAL), std::vector<LogDensity>(n + 1),
                        std::vector<LogDensity>(n + 1)};
    auto& [logs, from_camera, from_light] = densities;
    for (std::size_t i = 1; i <= n; ++i)
        from_camera[i] = log_density(scene, i >= 2 ? z[i - 2] : nullptr, *z[i - 1], *z[i]);
    from_light[n].value = std::log(density_of_origin(scene, *z[n], *z[n - 1]));
    for (std::size_t i = n; i-- > 1;)
        from_light[i] = log_density(scene, i + 2 <= n ? z[i + 2] : nullptr, *z[i + 1], *z[i]);
    for (std::size_t t = 1; t <= n + 1; ++t) {
        if (!can_make(chain, static_cast<int>(t))) continue;
        logs[t] = 0;
        for (std::size_t i = 1; i <= n; ++i) logs[t] += (i < t ? from_camera[i] : from_light[i]).value;
    }
    if (n >= 2 && can_make(chain, static_cast<int>(n)))
        logs[n] +=
            std::log(density_of_choice(scene, *choice_by_power(), *z[n], *z[n - 1], per_area)) - from_light[n].value;
    return densities;
}

// The power heuristic's weight of strategy t, and how far rounding may carry it.
struct BoundedWeight {
    double value, error;
};
BoundedWeight power_weight(const Densities& densities, std::size_t t) {
    if (densities.logs[t] == -HUGE_VAL) return {0, 1};  // rounding carried the path to the other side of a surface
    double sum = 0, least = 0, most = 0;
    for (std::size_t i = 1; i < densities.logs.size(); ++i) {
        if (densities.logs[i] == -HUGE_VAL) continue;
        const double log_ratio = densities.logs[i] - densities.logs[t], error = densities.error_of_ratio(i, t);
        sum += std::exp(2 * log_ratio);
        least += std::exp(2 * (log_ratio - error));
        most += std::exp(2 * (log_ratio + error));
    }
    return {1 / sum, std::max(1 / least - 1 / sum, 1 / sum - 1 / most)};
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
        for_each_path(scene(), run, [&, &scene_name = name](const PathChain& chain, int made_by) {
            double sum = 0;
            for (int t = 1; t <= chain.edges() + 1; ++t)
                if (can_make(chain, t)) sum += weight(chain, t);
            cases.push_back({fmt::format("{}, {} edges, made with t = {}", scene_name, chain.edges(), made_by),
                             std::abs(sum - 1), static_cast<double>(chain.edges())});
        });
    }
    return within_bound(cases, 1e-9, "of 1");
}

// Rays are not quite the lines between the vertices they found, the less so the nearer those are: weights are held to
// what that can change, path by path. Where it is more than `loose`, a path says little: few may be so.
Verdict weights_are_of_densities(Weight weight, const Run& run) {
    constexpr double loose = 0.01, most_loose = 0.005;
    std::vector<BoundedCase> cases;
    std::size_t held_loosely = 0;
    for (const auto& [name, scene] : scenes()) {
        run.end_if_stopped();
        for_each_path(scene(), run, [&, &scene_name = name](const PathChain& chain, int made_by) {
            if (std::ranges::count(chain.discrete, char{1})) return;
            const BoundedWeight truth = power_weight(densities_of(scene(), chain), static_cast<std::size_t>(made_by));
            held_loosely += !(truth.error <= loose);
            constexpr double of_doubles = 1e-9;
            cases.push_back({fmt::format("{}, {} edges, made with t = {}", scene_name, chain.edges(), made_by),
                             std::abs(weight(chain, made_by) - truth.value) / (truth.error + of_doubles),
                             static_cast<double>(chain.edges())});
        });
    }
    Verdict verdict = within_bound(cases, 1, "of what rounding can change");
    const double share = static_cast<double>(held_loosely) / static_cast<double>(cases.size());
    verdict.reason += fmt::format("; {:.2g} % of them may be off by more than {}; accepted: at most {} %", 100 * share,
                                  loose, 100 * most_loose);
    verdict.evidence.emplace_back("share_held_loosely", share);
    if (share > most_loose) verdict.outcome = Outcome::refuted;
    return verdict;
}

double choice_ignored(const PathChain& chain, int t) {
    PathChain other = chain;
    other.choice = chain.from_light.back();
    return strategy_weight(other, t);
}

}  // namespace

void add_transport_weights(Catalogue& catalogue) {
    catalogue.add({.id = "render/bdpt/weights-sum",
                   .statement = "The weights of all strategies that can make a path of up to 8 edges sum to 1.",
                   .source = "[Veach 1997, section 9.2]",
                   .kind = Kind::bounded,
                   .trial = {weights_sum_to_one,
                             strategy_weight,
                             {{"wrong-vertex", "The density of the next vertex in place of the connected one's.",
                               weight_of_wrong_vertex},
                              {"mirror-connected", "Connections to mirrors count as if they could be made.",
                               weight_with_mirrors_connected}}}});
    catalogue.add(
        {.id = "render/bdpt/weights-densities",
         .statement = "Weights are those of the products of densities, recomputed from vertices' positions.",
         .source = "[Veach 1997, eq. 9.13 and section 10.2]",
         .kind = Kind::bounded,
         .trial = {weights_are_of_densities,
                   strategy_weight,
                   {{"choice-ignored", "Lights are taken to be sampled as their subpaths begin.", choice_ignored},
                    {"wrong-vertex", "The density of the next vertex in place of the connected one's.",
                     weight_of_wrong_vertex}}}});
}

}  // namespace plumb::suites
