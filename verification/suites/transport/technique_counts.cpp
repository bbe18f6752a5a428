// Techniques of next-event estimation with counts of samples of their own, 0 among them, by several heuristics:
// `direct` and `path` find the same light by all.
//
// Weights by counts of 1 beside samples that are averaged by their counts are no mutant: they too sum to 1.

#include "verification/evidence/mean.h"
#include "verification/suites/suites.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

using Made = std::shared_ptr<const PathEstimator>;

struct Techniques {
    TechniqueCounts counts;
    MisWeight weight = mis_weight<Power>;
};

NextEvent next_event_of(const Techniques& techniques) {
    return with_counts(with_weight(techniques.weight), techniques.counts);
}
Made direct_by(const Techniques& techniques) {
    return std::make_shared<Direct>(next_event_of(techniques));
}
Made path_by(const Techniques& techniques) {
    auto path = std::make_shared<PathTracer>(PathLimits{.max_edges = 3, .roulette_edges = 2});
    path->next_event = next_event_of(techniques);
    return path;
}

/// Means of the lamps' film without what is seen directly, against those by one sample of each technique.
Verdict as_usual(Made (*by)(const Techniques&), const std::vector<Techniques>& all, const Run& run) {
    constexpr double mean = 0.3;
    const Scene& scene = lamps_scene();
    const Made usual = by({one_of_each});
    const RegionMean reference{scene, *usual, whole_film(scene), 4};
    std::vector<Verdict> parts;
    for (const Techniques& techniques : all) {
        const Made made = by(techniques);
        const RegionMean other{scene, *made, whole_film(scene), 4};
        parts.push_back(same_mean(reference, other,
                                  {.delta = run.pick(0.02, 0.005) * mean,
                                   .epsilon = 1e-5 * mean,
                                   .cap = run.pick(std::uint64_t{1} << 17, std::uint64_t{1} << 21)},
                                  run.part(fmt::format("{}", parts.size()), 1 / static_cast<double>(all.size()))));
        if (parts.back().outcome == Outcome::refuted) break;
    }
    return all_of(std::move(parts));
}

// ---- weights that are wrong where there are so many samples of lights and of the BSDF

template <int lights, int bsdf>
double rivals_counted_once(std::span<const double> densities, std::size_t own) {
    std::array counted{densities[0], densities[1]};
    counted[1 - own] /= own == 0 ? bsdf : lights;
    return mis_weight<Power>(counted, own);
}

template <int lights, int bsdf>
double summed(std::span<const double> densities, std::size_t own) {
    return mis_weight<Power>(densities, own) * (own == 0 ? lights : bsdf);
}

void add(Catalogue& catalogue, const std::string& name, Made (*by)(const Techniques&)) {
    using All = std::vector<Techniques>;
    constexpr TechniqueCounts two_lights{2, 1}, three_directions{1, 3};
    catalogue.add(
        {.id = fmt::format("render/{}/technique-counts/lamps", name),
         .statement = fmt::format("With 0 to 3 samples of lights and of BSDFs, by the power, balance or maximum "
                                  "heuristic, `{}` finds the same light.",
                                  name),
         .source = "[Veach 1997, eq. 9.4]",
         .kind = Kind::mean,
         .trial = {
             [by](const All& all, const Run& run) { return as_usual(by, all, run); },
             All{{lights_alone},
                 {bsdf_alone},
                 {two_lights},
                 {three_directions},
                 {three_directions, mis_weight<Balance>},
                 {two_lights, mis_weight<Maximum>}},
             {{"rivals-counted-once", "A weight counts its own samples, and one of the other technique.",
               All{{three_directions, rivals_counted_once<1, 3>}}},
              {"summed", "Samples of a technique are added up, not averaged.", All{{two_lights, summed<2, 1>}}}}}});
}

}  // namespace

void add_transport_technique_counts(Catalogue& catalogue) {
    add(catalogue, "direct", direct_by);
    add(catalogue, "path", path_by);
}

}  // namespace plumb::suites
