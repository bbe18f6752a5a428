// `path`, `light` and `bdpt` estimate the same pictures, but for classes of paths that one cannot make: scenes here
// have none of them in sight.

#include "verification/mean.h"
#include "verification/suites/rendering/transport_subjects.h"
#include "verification/suites/suites.h"

namespace plumb {
namespace {

struct Subject {
    std::string name, title;
    const Scene& (*scene)();
    double mean;  ///< luminance of the film's mean, to two digits: δ is a part of it
};

using Made = std::shared_ptr<const PathEstimator>;

PathLimits limits(int longest) {
    return {.max_edges = longest, .roulette_edges = 3};
}
template <class E>
Made made(int longest, const std::function<void(E&)>& change = {}) {
    E estimator(limits(longest));
    if (change) change(estimator);
    return std::make_shared<E>(std::move(estimator));
}

Verdict same_mean(const Scene& scene, const FilmRegion& region, const PathEstimator& a, const PathEstimator& b,
                  double delta, int length, const Run& run) {
    const RegionMean of_a{scene, a, region, 16, length}, of_b{scene, b, region, 16, length};
    const auto draw = [&](RandomStream& random) {
        const double first = of_a.draw(random);
        return of_b.draw(random) - first;
    };
    return mean_is(draw, {.delta = delta, .epsilon = 1e-5 * delta}, run);
}

Verdict same_film(const Subject& subject, const Made& a, const Made& b, const Run& run) {
    const Scene& scene = subject.scene();
    return same_mean(scene, whole_film(scene), *a, *b, run.pick(0.02, 0.005) * subject.mean, 0, run);
}

// A quarter of the film each; its light is known to lie within a factor of two of the film's.
Verdict same_tiles(const Subject& subject, const Made& a, const Made& b, const Run& run) {
    const Scene& scene = subject.scene();
    std::vector<Verdict> parts;
    for (int i = 0; i < 4; ++i) {
        const FilmRegion tile{16 * (i % 2), 16 * (i / 2), 16, 16};
        parts.push_back(same_mean(scene, tile, *a, *b, run.pick(0.1, 0.03) * subject.mean, 0,
                                  run.part(fmt::format("tile {}", i), 0.25)));
    }
    return all_of(std::move(parts));
}

Verdict same_lengths(const Subject& subject, const Made& a, const Made& b, const Run& run) {
    const Scene& scene = subject.scene();
    std::vector<Verdict> parts;
    for (int k = 2; k <= 4; ++k)
        parts.push_back(same_mean(scene, whole_film(scene), *a, *b, run.pick(0.02, 0.005) * subject.mean, k,
                                  run.part(fmt::format("length {}", k), 1.0 / 3)));
    return all_of(std::move(parts));
}

// Each strategy alone against `path` at the same length.
Verdict strategies_agree(const Scene& scene, int length, const std::function<void(Bdpt&)>& change, const Run& run) {
    std::vector<Verdict> parts;
    const auto path = made<PathTracer>(length);
    const double strategies = length + 1;
    for (int t = 1; t <= length + 1; ++t) {
        const int s = length + 1 - t;
        const auto alone = made<Bdpt>(length, [&](Bdpt& bdpt) {
            bdpt.weight = strategy_alone({s, t});
            if (change) change(bdpt);
        });
        parts.push_back(same_mean(scene, whole_film(scene), *path, *alone, run.pick(0.05, 0.01) * 0.15, length,
                                  run.part(fmt::format("({}, {})", s, t), 1 / strategies)));
    }
    return all_of(std::move(parts));
}

struct Defect {
    std::string id, sentence;
    Made estimator;
};
using Compare = Verdict (*)(const Subject&, const Made&, const Made&, const Run&);

void add(Catalogue& catalogue, const Subject& subject, const std::string& id, const std::string& what, Compare compare,
         const Made& reference, const Made& other, const std::vector<Defect>& defects) {
    Claim claim{
        .id = "render/" + id + "/" + subject.name,
        .statement = what + " " + subject.title + ".",
        .source = "[Veach 1997, chapters 8 and 10]",
        .kind = Kind::mean,
        .check = [=](const Run& run) { return compare(subject, reference, other, run); },
    };
    for (const Defect& defect : defects)
        claim.mutants.push_back({defect.id, defect.sentence,
                                 [=](const Run& run) { return compare(subject, reference, defect.estimator, run); }});
    catalogue.add(std::move(claim));
}

double without_correction(const PathVertex&, Vec3) {
    return 1;
}
double inverse_correction(const PathVertex& vertex, Vec3 wi) {
    const double right = shading_correction(vertex, wi);
    return right > 0 ? 1 / right : 0;
}

double mirrors_ignored(const PathChain& chain, int t) {
    PathChain other = chain;
    std::ranges::fill(other.discrete, char{0});
    return strategy_weight(other, t);
}

}  // namespace

void add_transport_equal_claims(Catalogue& catalogue) {
    const Subject box{"box", "a box of touching walls", box_scene, 0.3};
    const Subject rough{"rough", "rough glass, metal and coats through a lens", rough_scene, 0.3};
    const Subject caustic{"caustic", "light out of a ball of glass and off a mirror", caustic_scene, 0.3};
    const Subject smooth{"smooth-normals", "a surface with shading normals", smooth_normals_scene, 0.3};
    const auto path = [](int longest) { return made<PathTracer>(longest); };
    const auto light = [](int longest) { return made<LightTracer>(longest); };
    const auto bdpt = [](int longest) { return made<Bdpt>(longest); };

    const std::vector<Defect> no_direct{{"strategy-left-out",
                                         "Emitters are not sampled: strategies (1, t) are left out.",
                                         made<Bdpt>(4, [](Bdpt& bdpt) {
                                             bdpt.weight = [](const PathChain& chain, int t) {
                                                 return t == chain.edges() ? 0 : strategy_weight(chain, t);
                                             };
                                         })}};
    add(catalogue, box, "path-is-light", "`path` and `light` agree on", same_film, path(4), light(4),
        {{"dim", "Light paths carry 5 % less.", std::make_shared<Scaled>(light(4), 0.95)}});
    add(catalogue, box, "path-is-bdpt", "`path` and `bdpt` agree on", same_film, path(4), bdpt(4), no_direct);
    add(catalogue, box, "lengths-agree", "At each length, `path` and `bdpt` agree on", same_lengths, path(4), bdpt(4),
        no_direct);
    add(catalogue, box, "tiles-agree", "In each quarter of the film, `light` and `bdpt` agree on", same_tiles, bdpt(4),
        light(4), {{"dim", "Light paths carry 60 % less.", std::make_shared<Scaled>(light(4), 0.4)}});

    const std::vector<Defect> dim{{"dim", "Light paths carry 5 % less.", std::make_shared<Scaled>(light(3), 0.95)}};
    add(catalogue, rough, "path-is-light", "`path` and `light` agree on", same_film, path(3), light(3), dim);
    add(catalogue, rough, "path-is-bdpt", "`path` and `bdpt` agree on", same_film, path(3), bdpt(3),
        {{"eta-squared-on-both-sides", "Refraction compresses the light's subpath too.",
          made<Bdpt>(3, [](Bdpt& bdpt) { bdpt.rules.from_light = Transport::radiance; })}});

    const auto squared = made<LightTracer>(4, [](LightTracer& tracer) { tracer.carries = Transport::radiance; });
    add(catalogue, caustic, "path-is-light", "`path` and `light` agree on", same_film, path(4), light(4),
        {
            {"eta-squared-on-both-sides", "Refraction compresses light on its way from the source too.", squared},
        });
    add(catalogue, caustic, "path-is-bdpt", "`path` and `bdpt` agree on", same_film, path(4), bdpt(4),
        {{"mirror-connected", "Weights count connections to mirrors as if they could be made.",
          made<Bdpt>(4, [](Bdpt& bdpt) { bdpt.weight = mirrors_ignored; })},
         {"eta-squared-on-both-sides", "Refraction compresses the light's subpath too.",
          made<Bdpt>(4, [](Bdpt& bdpt) { bdpt.rules.from_light = Transport::radiance; })},
         {"eta-squared-on-neither-side", "Refraction does not compress the sensor's subpath.",
          made<Bdpt>(4, [](Bdpt& bdpt) { bdpt.rules.from_camera = Transport::importance; })}});

    add(catalogue, smooth, "path-is-light", "`path` and `light` agree on", same_film, path(4), light(4),
        {{"without-correction", "Veach's factor for shading normals is missing.",
          made<LightTracer>(4, [](LightTracer& tracer) { tracer.correction = without_correction; })},
         {"inverse-correction", "Veach's factor for shading normals is inverted.",
          made<LightTracer>(4, [](LightTracer& tracer) { tracer.correction = inverse_correction; })}});
    add(catalogue, smooth, "path-is-bdpt", "`path` and `bdpt` agree on", same_film, path(4), bdpt(4),
        {{"inverse-correction", "Veach's factor for shading normals is inverted.",
          made<Bdpt>(4, [](Bdpt& bdpt) { bdpt.rules.correction = inverse_correction; })}});

    catalogue.add(
        {.id = "render/bdpt/strategies-alone",
         .statement = "Each strategy of three edges alone agrees with `path` where no surfaces touch.",
         .source = "[Veach 1997, section 10.2]",
         .kind = Kind::mean,
         .check = [](const Run& run) { return strategies_agree(plates_scene(), 3, {}, run); },
         .mutants = {{"inverted-jacobian", "Connections are multiplied by d² instead of 1/d².", [](const Run& run) {
                          const auto change = [](Bdpt& bdpt) {
                              bdpt.rules.falloff = [](const SubpathVertex& x, const SubpathVertex& y) {
                                  return 1 / falloff(x, y);
                              };
                          };
                          return strategies_agree(plates_scene(), 3, change, run);
                      }}}});
}

}  // namespace plumb
