// The radiances that are known in the shipped scenes, of paths of one and two edges, found by the renderer.

#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/known_radiances.h"
#include "scenes/shipped/shipped.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"
#include "verification/suites/direct/direct_subjects.h"

namespace plumb::suites {
namespace {

std::vector<KnownRadiance> direct_radiances(const ShippedScene& shipped) {
    std::vector<KnownRadiance> direct = known_radiances(shipped.expected()).radiances;
    std::erase_if(direct, [](const KnownRadiance& r) { return r.edges.value_or(3) > 2; });
    return direct;
}

Point<2> in_box(const FilmBox& box, RandomStream& random) {
    const double u = random.uniform();
    return {box.x + u * box.width, box.y + random.uniform() * box.height};
}

/// The mean of 32 paths through the film point, or the box, of a known radiance.
double draw_known(const Scene& scene, const PathEstimator& estimator, const KnownRadiance& known,
                  RandomStream& random) {
    Measurement measurement{scene, estimator, known.film, {}, 32, known.edges.value_or(2)};
    if (known.over == KnownRadiance::Over::point) return luminance(measurement.draw(random));
    measurement.n = 1;
    double sum = 0;
    for (int i = 0; i < 32; ++i) {
        measurement.film = in_box(known.box, random);
        sum += luminance(measurement.draw(random));
    }
    return sum / 32;
}

/// The spread of the first values.
double spread(const Draw& draw, const Run& run) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::uint64_t i = 0; i < 64; ++i) {
        RandomStream random = run.random(i);
        const double value = draw(random);
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return high - low;
}

Verdict is_known(const Scene& scene, const PathEstimator& estimator, const KnownRadiance& known, const Run& run) {
    // A film point and a scene in single precision: what is seen moves by some 1e-6 of its distance.
    const double value = luminance(known.value), delta = value > 0 ? 1e-2 * value : 1e-3;
    const double allowed = known.error + std::max(2e-5 * value, 1e-12);
    const auto draw = [&](RandomStream& random) { return draw_known(scene, estimator, known, random); };
    // Where nothing is left to chance, every value is held to the claim.
    const bool constant = spread(draw, run.part("spread")) <= allowed;
    return mean_is(draw,
                   {.reference = value,
                    .delta = delta,
                    .epsilon = allowed,
                    .why_fewer = "lights in full sight of the paths of every draw",
                    .cap = constant ? std::uint64_t{256} : std::uint64_t{1} << 20,
                    .zero_variance = constant},
                   run);
}

Verdict all_known(const ShippedScene& shipped, const PathEstimator& estimator, const Run& run) {
    const Scene scene(load_mitsuba(shipped.file));
    const std::vector<KnownRadiance> known = direct_radiances(shipped);
    std::vector<Verdict> parts;
    for (std::size_t i = 0; i < known.size(); ++i) {
        parts.push_back(is_known(scene, estimator, known[i],
                                 run.part(fmt::format("{}", i), 1 / static_cast<double>(known.size()))));
        if (parts.back().outcome == Outcome::refuted) break;  // so is the whole
    }
    return all_of(std::move(parts));
}

using Estimator = std::shared_ptr<const PathEstimator>;

/// Adds to every path what a black point does not hide.
struct Foggy final : PathEstimator {
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override {
        Direct().trace(scene, region, samples, record);
        record.splats.push_back({record.splats.front().film, Spectrum::grey(2.5e-3), 1});
    }
};

}  // namespace

void add_direct_known(Catalogue& catalogue) {
    for (const ShippedScene& shipped : shipped_scenes()) {
        const std::size_t count = direct_radiances(shipped).size();
        if (count == 0) continue;
        const auto check = [=](const Estimator& estimator, const Run& run) {
            return all_known(shipped, *estimator, run);
        };
        const auto black = [](const KnownRadiance& r) { return is_black(r.value); };
        const auto known = direct_radiances(shipped);
        const Wrong<Estimator> slightly_bright{"slightly-bright", "2.5 % too bright.",
                                               std::make_shared<Scaled>(std::make_shared<Direct>(), 1.025)};
        const Wrong<Estimator> fog{"fog", "2.5e-3 is added everywhere.", std::make_shared<Foggy>()};
        catalogue.add(
            {.id = fmt::format("direct/{}/known", shipped.name),
             .statement = fmt::format("Direct light in the scene {} has the {} {} that its expected.json knows.",
                                      shipped.name, count, count == 1 ? "radiance" : "radiances"),
             .source = fmt::format("scenes/shipped/{}/expected.json", shipped.name),
             .kind = Kind::mean,
             .trial = {
                 check, std::make_shared<Direct>(), {std::ranges::all_of(known, black) ? fog : slightly_bright}}});
    }
}

}  // namespace plumb::suites
