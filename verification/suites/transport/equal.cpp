// `path`, `light` and `bdpt` estimate the same pictures, but for classes of paths that one cannot make: scenes here
// have none of them in sight.

#include "verification/claim.h"
#include "verification/evidence/mean.h"
#include "verification/suites/transport/transport_subjects.h"

namespace plumb::suites {
namespace {

struct Subject {
    std::string name, title;
    const Scene& (*scene)();
    double mean;                  ///< of the film's luminance, lights seen directly left out: the unit of δ
    std::array<double, 4> tiles;  ///< of its quarters', row by row
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

// Paths of a draw: few where δ is wide, for a test makes 1,000 draws at least.
struct Lot {
    std::uint32_t paths = 16;
    int length = 0;  ///< of the paths, where one counts
};

Verdict same_mean(const Scene& scene, const FilmRegion& region, const PathEstimator& a, const PathEstimator& b,
                  double delta, const Lot& lot, const Run& run) {
    const RegionMean of_a{scene, a, region, lot.paths, lot.length}, of_b{scene, b, region, lot.paths, lot.length};
    const auto draw = [&](RandomStream& random) {
        const double first = of_a.draw(random);
        return of_b.draw(random) - first;
    };
    return mean_is(draw,
                   {.delta = delta,
                    .epsilon = 1e-5 * delta,
                    .why_fewer = "several paths in every pixel of the region, among them some of each kind",
                    .cap = run.pick(std::uint64_t{1} << 20, std::uint64_t{1} << 24)},
                   run);
}

// The whole film within 2 %, then each quarter within 10 % of its own light; in the full size 0.5 % and 3 %.
Verdict same_picture(const Subject& subject, const Made& a, const Made& b, const Run& run) {
    const Scene& scene = subject.scene();
    std::vector<Verdict> parts{
        same_mean(scene, whole_film(scene), *a, *b, run.pick(0.02, 0.005) * subject.mean, {}, run.part("film", 0.2))};
    for (std::size_t i = 0; i < 4 && parts.back().outcome != Outcome::refuted; ++i) {
        const int x = 16 * static_cast<int>(i % 2), y = 16 * static_cast<int>(i / 2);
        parts.push_back(same_mean(scene, {x, y, 16, 16}, *a, *b, run.pick(0.1, 0.03) * subject.tiles[i], {4},
                                  run.part(fmt::format("tile {}", i), 0.2)));
    }
    return all_of(std::move(parts));
}

Verdict same_lengths(const Subject& subject, const Made& a, const Made& b, const Run& run) {
    const Scene& scene = subject.scene();
    std::vector<Verdict> parts;
    for (int k = 2; k <= 4; ++k)
        parts.push_back(same_mean(scene, whole_film(scene), *a, *b, run.pick(0.02, 0.005) * subject.mean, {16, k},
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
        parts.push_back(same_mean(scene, whole_film(scene), *path, *alone, run.pick(0.15, 0.01) * 0.018, {16, length},
                                  run.part(fmt::format("({}, {})", s, t), 1 / strategies)));
    }
    return all_of(std::move(parts));
}

using Defect = Wrong<Made>;
using Compare = Verdict (*)(const Subject&, const Made&, const Made&, const Run&);

void add(Catalogue& catalogue, const Subject& subject, const std::string& id, const std::string& what, Compare compare,
         const Made& reference, const Made& other, const std::vector<Defect>& defects) {
    catalogue.add({
        .id = "render/" + id + "/" + subject.name,
        .statement = what + " " + subject.title + ".",
        .source = "[Veach 1997, chapters 8 and 10]",
        .kind = Kind::mean,
        .trial = {[=](const Made& made, const Run& run) { return compare(subject, reference, made, run); }, other,
                  defects},
    });
}

double without_correction(const PathVertex&, Vec3) {
    return 1;
}
double inverted(const SubpathVertex& x, const SubpathVertex& y) {
    return 1 / falloff(x, y);
}
double without_cosine(const SubpathVertex& x, const SubpathVertex& y) {
    return falloff(x, y) / std::abs(dot(y.normal(), y.towards(x)));
}
std::function<void(Bdpt&)> with_falloff(Falloff other) {
    return [other](Bdpt& bdpt) { bdpt.rules.falloff = other; };
}

// Light that the box's film has, but in the wrong place: its first quarter takes it from the third.
struct LightMoved final : PathEstimator {
    Made estimator;
    explicit LightMoved(Made e) : estimator(std::move(e)) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        estimator->trace(scene, region, samples, record);
        for (Splat& splat : record.splats)
            if (splat.film[0] < 16) splat.value *= splat.film[1] < 16 ? 1.25 : 1 - 0.25 * 0.119 / 0.144;
    }
};

template <class E>
Made correct(int longest) {
    return made<E>(longest);
}
Made without_light_samples(int longest) {
    return made<Bdpt>(longest, [](Bdpt& bdpt) {
        bdpt.weight = [](const PathChain& chain, int t) { return t == chain.edges() ? 0 : strategy_weight(chain, t); };
    });
}
Defect left_out(int longest) {
    return {"strategy-left-out", "Lights are not sampled: strategies (1, t) are left out.",
            without_light_samples(longest)};
}

void add_box(Catalogue& catalogue) {
    const Subject box{"box", "a box of touching walls through a lens", box_scene, 0.120, {0.119, 0.113, 0.144, 0.105}};
    const Made path = correct<PathTracer>(4), light = correct<LightTracer>(4), bdpt = correct<Bdpt>(4);
    add(catalogue, box, "path-is-light", "`path` and `light` agree on", same_picture, path, light,
        {{"dim", "Light paths carry 5 % less.", std::make_shared<Scaled>(light, 0.95)}});
    add(catalogue, box, "path-is-bdpt", "`path` and `bdpt` agree on", same_picture, path, bdpt,
        {left_out(4),
         {"light-moved", "A quarter of the film takes a fifth of another's light; the film's mean stays.",
          std::make_shared<LightMoved>(bdpt)}});
    add(catalogue, box, "lengths-agree", "At each length, `path` and `bdpt` agree on", same_lengths, path, bdpt,
        {left_out(4)});
}

void add_rough(Catalogue& catalogue) {
    const Subject rough{"rough", "rough glass, metal and coats", rough_scene, 0.205, {0.268, 0.269, 0.131, 0.151}};
    const Made path = correct<PathTracer>(3), light = correct<LightTracer>(3), bdpt = correct<Bdpt>(3);
    add(catalogue, rough, "path-is-light", "`path` and `light` agree on", same_picture, path, light,
        {{"dim", "Light paths carry 5 % less.", std::make_shared<Scaled>(light, 0.95)}});
    add(catalogue, rough, "path-is-bdpt", "`path` and `bdpt` agree on", same_picture, path, bdpt, {left_out(3)});
}

void add_caustic(Catalogue& catalogue) {
    const Subject caustic{
        "caustic", "light out of a ball of glass and off mirrors", caustic_scene, 0.4155, {0.414, 0.416, 0.416, 0.415}};
    const Made path = correct<PathTracer>(5), light = correct<LightTracer>(5), bdpt = correct<Bdpt>(5);
    add(catalogue, caustic, "path-is-light", "`path` and `light` agree on", same_picture, path, light,
        {{"eta-squared-on-both-sides", "Refraction compresses light on its way from the source too.",
          made<LightTracer>(5, [](LightTracer& tracer) { tracer.carries = Transport::radiance; })}});
    add(catalogue, caustic, "path-is-bdpt", "`path` and `bdpt` agree on", same_picture, path, bdpt,
        {{"mirror-connected", "Weights count connections to mirrors as if they could be made.",
          made<Bdpt>(5, [](Bdpt& other) { other.weight = weight_with_mirrors_connected; })},
         {"eta-squared-on-both-sides", "Refraction compresses the light's subpath too.",
          made<Bdpt>(5, [](Bdpt& other) { other.rules.from_light = Transport::radiance; })},
         {"eta-squared-on-neither-side", "Refraction does not compress the sensor's subpath.",
          made<Bdpt>(5, [](Bdpt& other) { other.rules.from_camera = Transport::importance; })}});
}

void add_smooth_normals(Catalogue& catalogue) {
    const Subject smooth{
        "smooth-normals", "a surface with shading normals", smooth_normals_scene, 0.124, {0.0840, 0.111, 0.129, 0.175}};
    const Made path = correct<PathTracer>(4), light = correct<LightTracer>(4), bdpt = correct<Bdpt>(4);
    add(catalogue, smooth, "path-is-light", "`path` and `light` agree on", same_picture, path, light,
        {{"without-correction", "Veach's factor for shading normals is missing.",
          made<LightTracer>(4, [](LightTracer& tracer) { tracer.correction = without_correction; })}});
    add(catalogue, smooth, "path-is-bdpt", "`path` and `bdpt` agree on", same_picture, path, bdpt, {left_out(4)});
}

void add_strategies(Catalogue& catalogue) {
    const auto check = [](const std::function<void(Bdpt&)>& change, const Run& run) {
        return strategies_agree(plates_scene(), 3, change, run);
    };
    catalogue.add(
        {.id = "render/bdpt/strategies-alone",
         .statement = "Each strategy of three edges alone agrees with `path` where no surfaces touch.",
         .source = "[Veach 1997, section 10.2]",
         .kind = Kind::mean,
         .trial = {check,
                   {},
                   {{"inverted-jacobian", "Connections are multiplied by d² instead of 1/d².", with_falloff(inverted)},
                    {"one-cosine", "The cosine at the light's end of connections is left out.",
                     with_falloff(without_cosine)}}}});
}

}  // namespace

void add_transport_equal(Catalogue& catalogue) {
    add_box(catalogue);
    add_rough(catalogue);
    add_caustic(catalogue);
    add_smooth_normals(catalogue);
    add_strategies(catalogue);
}

}  // namespace plumb::suites
