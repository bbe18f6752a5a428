// Random replay: what an estimator traces at the other pixel from the same numbers, bit by bit; and so are the parts of
// a hybrid shift before its connection.

#include "integrators/integrators.h"
#include "verification/suites/shift/shift_subjects.h"
#include "verification/suites/suites.h"
#include "verification/suites/tally.h"

namespace plumb::suites {
namespace {

bool same(const Splat& a, const Splat& b) {
    return a.value == b.value && a.film == b.film && a.edges == b.edges && a.anywhere == b.anywhere;
}

// Gives the numbers of the next sample once a path is traced.
struct OtherNumbers final : PathShift {
    RandomReplay replay;

    explicit OtherNumbers(const PathEstimator& estimator) : replay(estimator) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, BasePath& base) const override {
        replay.trace(scene, region, samples, base);
    }
    void shift(const Scene& scene, const BasePath& base, const FilmRegion& region, PrimarySamples&,
               ShiftedPath& shifted) const override {
        IndependentSamples others({1, 2, 3});
        replay.shift(scene, base, region, others, shifted);
    }
};
using MakeReplay = std::function<std::unique_ptr<PathShift>(const PathEstimator&)>;
template <class Shift>
std::unique_ptr<PathShift> make_replay(const PathEstimator& estimator) {
    return std::make_unique<Shift>(estimator);
}

Verdict replays(const MakeReplay& make, const Run& run) {
    Tally tally;
    const std::uint64_t seed = run.random(0).bits();
    for (const NamedIntegrator& named : integrators()) {
        const auto estimator = make_integrator(named.id, {});
        const auto shift = make(*estimator);
        for (const auto& [name, pixels] : shift_scenes())
            for (std::uint32_t i = 0; i < run.pick(20u, 500u); ++i) {
                IndependentSamples numbers({seed, 0, i});
                BasePath base;
                ShiftedPath shifted;
                PathRecord truth;
                shift->trace(pixels.scene, pixels.from, numbers, base);
                shift->shift(pixels.scene, base, pixels.to, numbers, shifted);
                estimator->trace(pixels.scene, pixels.to, numbers, truth);
                const bool right = shifted.parts.size() == 1 && shifted.parts[0].valid() &&
                                   shifted.parts[0].jacobian == 1 &&
                                   std::ranges::equal(shifted.splats, truth.splats, same, &PartSplat::splat);
                tally.expect(right, [&, &scene_name = name] {
                    return fmt::format("{} of {}: sample {} is not replayed", named.id, scene_name, i);
                });
            }
    }
    return tally.verdict("paths replayed");
}

Verdict heads_are_replayed(const MakeShift& make, const Run& run) {
    Tally tally;
    const PathTracer tracer;
    const auto shift = make(tracer);
    const std::uint64_t seed = run.random(0).bits();
    BasePath base;
    ShiftedPath shifted;
    for (const auto& [name, pixels] : shift_scenes())
        for (std::uint32_t i = 0; i < run.pick(200u, 5'000u); ++i) {
            run.end_if_stopped();
            IndependentSamples numbers({seed, 0, i});
            shift->trace(pixels.scene, pixels.to, numbers, base);
            const std::vector<PartSplat> truth = base.splats;
            shift->trace(pixels.scene, pixels.from, numbers, base);
            shift->shift(pixels.scene, base, pixels.to, numbers, shifted);
            for (const PartSplat& splat : shifted.splats) {
                if (base.connection > 0 && splat.part >= base.connection) continue;
                const bool right =
                    shifted.parts[splat.part].jacobian == 1 && std::ranges::any_of(truth, [&](const PartSplat& other) {
                        return other.part == splat.part && same(other.splat, splat.splat);
                    });
                tally.expect(right, [&, &scene_name = name] {
                    return fmt::format("{}: part {} of sample {} is not replayed", scene_name, splat.part, i);
                });
            }
        }
    return tally.verdict("splats before a connection replayed");
}

// The throughput that reached the base takes the place of that at the other pixel.
struct BasesLight final : PathShift {
    HybridShift inner;

    explicit BasesLight(const PathTracer& tracer) : inner(tracer) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, BasePath& base) const override {
        inner.trace(scene, region, samples, base);
    }
    void shift(const Scene& scene, const BasePath& base, const FilmRegion& region, PrimarySamples& samples,
               ShiftedPath& shifted) const override {
        inner.shift(scene, base, region, samples, shifted);
        shifted.splats = base.splats;
    }
};

}  // namespace

void add_shift_replays(Catalogue& catalogue) {
    catalogue.add(
        {.id = "shift/replay/same-numbers",
         .statement = "Random replay of any integrator is what it traces at the other pixel from the same "
                      "numbers, bit by bit, with the Jacobian 1.",
         .source = "ours, integrators/paths/shift.h",
         .kind = Kind::exact,
         .trial = {replays,
                   make_replay<RandomReplay>,
                   {{"other-numbers", "The numbers are those of another path.", make_replay<OtherNumbers>}}}});
    catalogue.add(
        {.id = "shift/path/head",
         .statement = "Before its connection a hybrid shift is random replay, bit by bit, with the Jacobian 1.",
         .source = "ours, integrators/estimators/hybrid_shift.h",
         .kind = Kind::exact,
         .trial = {
             heads_are_replayed, hybrid, {{"base", "The light is that of the base.", [](const PathTracer& tracer) {
                                               return std::make_unique<BasesLight>(tracer);
                                           }}}}});
}

}  // namespace plumb::suites
