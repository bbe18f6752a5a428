// Shifted paths are paths: from the numbers that lead there, `path` traces them itself, finds the same light, and its
// own shift leads back.

#include "verification/evidence/deterministic.h"
#include "verification/suites/shift/shift_subjects.h"
#include "verification/suites/suites.h"

namespace plumb::suites {
namespace {

// Rays start beside the surfaces that they leave and end beside those they meet, so that a traced vertex is not quite
// the kept one, and values differ by what rounding makes of that.
double relative(const Spectrum& found, const Spectrum& truth) {
    return std::abs(luminance(found) - luminance(truth)) / (luminance(found) + luminance(truth) + 1e-300);
}

// Of each valid part at or behind the connection, the largest of three deviations: of its light from what `path` finds
// there, of the light of the shift back from the base's, of the product of both Jacobians from 1.
struct RoundTrip {
    const PixelPair& pixels;
    const PathShift& there;
    const PathShift& back;
    BasePath base = {}, traced = {};
    ShiftedPath shifted = {}, returned = {};

    void measure(PrimarySamples& numbers, std::vector<double>& deviations);

private:
    [[nodiscard]] double deviation(std::size_t part) const;
};

void RoundTrip::measure(PrimarySamples& numbers, std::vector<double>& deviations) {
    const auto& [scene, from, to] = pixels;
    there.trace(scene, from, numbers, base);
    there.shift(scene, base, to, numbers, shifted);
    const auto found = numbers_of_shift(scene, base, shifted);
    if (!found) return;
    Replaced other(numbers);
    const auto replace = [&](std::size_t vertex, const std::optional<std::array<double, 3>>& u) {
        if (!u) return;
        const auto number = static_cast<std::uint16_t>(vertex);
        other.set({number, Use::lobe}, {(*u)[0], 0});
        other.set({number, Use::direction}, {(*u)[1], (*u)[2]});
    };
    replace(base.connection, found->at_connection);
    replace(base.connection + 1, found->beyond);
    back.trace(scene, to, other, traced);
    back.shift(scene, traced, from, other, returned);
    const std::size_t last = found->beyond ? base.parts : base.connection + 1;
    for (std::size_t part = base.connection; part < last; ++part)
        if (shifted.parts[part].valid()) deviations.push_back(deviation(part));
}

double RoundTrip::deviation(std::size_t part) const {
    if (traced.connection != base.connection || part >= traced.parts || !returned.parts[part].valid()) return HUGE_VAL;
    return std::max({relative(light_of_part(shifted.splats, part), light_of_part(traced.splats, part)),
                     relative(light_of_part(returned.splats, part), light_of_part(base.splats, part)),
                     std::abs(shifted.parts[part].jacobian * returned.parts[part].jacobian - 1)});
}

// Shifts by another tracer than the one that makes the paths.
struct ShiftedByAnother final : PathShift {
    HybridShift right;
    PathTracer other;
    HybridShift wrong{other};

    ShiftedByAnother(const PathTracer& tracer, const PathTracer& defective) : right(tracer), other(defective) {}
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples, BasePath& base) const override {
        right.trace(scene, region, samples, base);
    }
    void shift(const Scene& scene, const BasePath& base, const FilmRegion& region, PrimarySamples& samples,
               ShiftedPath& shifted) const override {
        wrong.shift(scene, base, region, samples, shifted);
    }
};
std::unique_ptr<PathShift> weighted_by_balance(const PathTracer& tracer) {
    PathTracer other = tracer;
    other.next_event.weight = mis_weight<Balance>;
    return std::make_unique<ShiftedByAnother>(tracer, other);
}
std::unique_ptr<PathShift> without_roulette(const PathTracer& tracer) {
    PathTracer other = tracer;
    other.survival = [](const Spectrum&, double) { return 1.0; };
    return std::make_unique<ShiftedByAnother>(tracer, other);
}

struct ThereAndBack {
    MakeShift there, back;
};

Verdict lead_back(const ThereAndBack& shifts, const Run& run) {
    const PathTracer tracer({.roulette_edges = 2});
    const auto forth = shifts.there(tracer), returning = shifts.back(tracer);
    std::vector<std::pair<std::string, std::vector<double>>> deviations;
    const std::uint64_t seed = run.random(0).bits();
    for (const auto& [name, pixels] : shift_scenes()) {
        RoundTrip trip{pixels, *forth, *returning};
        std::vector<double>& found = deviations.emplace_back(name, std::vector<double>()).second;
        for (std::uint32_t i = 0; i < run.pick(600u, 10'000u); ++i) {
            run.end_if_stopped();
            IndependentSamples numbers({seed, 0, i});
            trip.measure(numbers, found);
        }
    }
    return nearly_all_agree(deviations);
}

}  // namespace

void add_shift_round_trips(Catalogue& catalogue) {
    catalogue.add(
        {.id = "shift/path/there-and-back",
         .statement = "From the numbers that lead to a shifted path `path` traces it, finds the same light in each "
                      "part, and its shift back is the base, with the reciprocal Jacobian.",
         .source = "ours, integrators/estimators/hybrid_shift.h",
         .kind = Kind::bounded,
         .trial = {lead_back,
                   {hybrid, hybrid},
                   {{"other-weights",
                     "Shifted light is weighted by the balance heuristic, traced light by the power.",
                     {weighted_by_balance, hybrid}},
                    {"roulette-not-played", "Roulette is played for the base alone.", {without_roulette, hybrid}},
                    {"one-way",
                     "The Jacobian has its cosines on the way there alone.",
                     {hybrid, hybrid_by([](const Connection& c) { return c.pdf / (c.distance * c.distance); })}}}}});
}

}  // namespace plumb::suites
