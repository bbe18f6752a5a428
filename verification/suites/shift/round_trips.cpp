// Shifted paths are paths: from the numbers that lead there, `path` traces them itself, finds the same light, and its
// own shift leads back.
//
// A ray misses the point that it is sent to, by what rounding to floats makes of it (ray_miss): the traced path is that
// of numbers a little off, and so are the light it finds and its shift back. How much that changes is asked of `path`
// itself, with the directions at the connection and behind it turned by as much as their rays may miss, in eight
// combinations of signs s. To first order a change is Σ s_i g_i over the four angles. The signs are an orthogonal
// array: the mean of its square over the eight is Σ g_i², so that no miss of that size changes more than
//   Σ |g_i| ≤ 2 √(Σ g_i²) ≤ 2 max_s |Σ s_i g_i|.
// Where the eight do not agree with the unturned path on what there is, an edge is near, and nothing is said.

#include "verification/suites/shift/shift_subjects.h"
#include "verification/suites/suites.h"

namespace plumb::suites {
namespace {

// What `path` finds in a part from given numbers: its light, that of the shift back, and the product of both Jacobians.
// All of it is infinite where the part is not there.
using Found = std::array<double, 3>;
constexpr Found nothing{HUGE_VAL, HUGE_VAL, HUGE_VAL};

// A path there and back, part by part from the connection on.
struct RoundTrip {
    const PixelPair& pixels;
    const PathShift& there;
    const PathShift& back;
    BasePath base = {}, traced = {};
    ShiftedPath shifted = {}, returned = {};

    void measure(const std::string& name, PrimarySamples& numbers, HeldCases& cases);

private:
    [[nodiscard]] std::vector<Found> found_by(PrimarySamples& numbers, const NumbersOfShift& direction);
    [[nodiscard]] double turn_at_connection() const;
    [[nodiscard]] double turn_beyond() const;
};

std::vector<Found> RoundTrip::found_by(PrimarySamples& numbers, const NumbersOfShift& directions) {
    Replaced other(numbers);
    const auto replace = [&](std::size_t vertex, const std::optional<LobeNumbers>& u) {
        if (!u) return;
        const auto number = static_cast<std::uint16_t>(vertex);
        other.set({number, Use::lobe}, {(*u)[0], 0});
        other.set({number, Use::direction}, {(*u)[1], (*u)[2]});
    };
    replace(base.connection, directions.at_connection);
    replace(base.connection + 1, directions.beyond);
    back.trace(pixels.scene, pixels.to, other, traced);
    back.shift(pixels.scene, traced, pixels.from, other, returned);
    std::vector<Found> found;
    for (std::size_t part = base.connection; part < base.parts; ++part) {
        const bool there_is =
            traced.connection == base.connection && part < traced.parts && returned.parts[part].valid();
        found.push_back(there_is ? Found{luminance(light_of_part(traced.splats, part)),
                                         luminance(light_of_part(returned.splats, part)),
                                         shifted.parts[part].jacobian * returned.parts[part].jacobian}
                                 : nothing);
    }
    return found;
}

double RoundTrip::turn_at_connection() const {
    const auto& vertices = base.record.vertices;
    if (vertices.size() <= base.connection) return ray_turn;
    const SurfacePoint &from = shifted.record.vertices[base.connection - 1].hit.point,
                       &to = vertices[base.connection].hit.point;
    return ray_miss(from, to) / length(to.position - from.position);
}

// The rays of the base and those of the traced path miss, each of them; a miss further on is taken for one at once.
double RoundTrip::turn_beyond() const {
    const auto& vertices = base.record.vertices;
    if (vertices.size() <= base.connection + 1) return 2 * ray_turn;
    const auto point = [&](std::size_t i) -> const SurfacePoint& { return vertices[i].hit.point; };
    double sum = 0;
    for (std::size_t i = base.connection; i + 1 < vertices.size(); ++i) sum += 2 * ray_miss(point(i), point(i + 1));
    return sum / length(point(base.connection + 1).position - point(base.connection).position);
}

void RoundTrip::measure(const std::string& name, PrimarySamples& numbers, HeldCases& cases) {
    there.trace(pixels.scene, pixels.from, numbers, base);
    there.shift(pixels.scene, base, pixels.to, numbers, shifted);
    const auto directions = numbers_of_shift(pixels.scene, base, shifted);
    if (!directions) return;
    const std::vector<Found> found = found_by(numbers, *directions);
    std::vector<Found> changes(found.size(), Found{});
    const double a = turn_at_connection(), b = turn_beyond();
    for (unsigned i = 0; i < 8; ++i) {
        const auto sign = [i](unsigned bit) { return i >> bit & 1 ? 1.0 : -1.0; };
        const Turned turned{{a * sign(0), a * sign(1)}, {b * sign(2), b * sign(0) * sign(1) * sign(2)}};
        const auto near = numbers_of_shift(pixels.scene, base, shifted, turned, *directions);
        if (!near || near->beyond.has_value() != directions->beyond.has_value()) return;
        const std::vector<Found> others = found_by(numbers, *near);
        for (std::size_t j = 0; j < found.size(); ++j)
            for (std::size_t q = 0; q < 3; ++q) {
                const bool same = found[j][q] == others[j][q];  // both may be nothing
                changes[j][q] = std::max(changes[j][q], same ? 0 : std::abs(others[j][q] - found[j][q]));
            }
    }
    const std::size_t parts = directions->beyond ? found.size() : 1;
    for (std::size_t j = 0; j < parts; ++j) {
        const std::size_t part = base.connection + j;
        if (!shifted.parts[part].valid()) continue;
        const Found kept{luminance(light_of_part(shifted.splats, part)), luminance(light_of_part(base.splats, part)),
                         1};
        for (std::size_t q = 0; q < 3; ++q) {
            if (found[j][q] == kept[q]) continue;
            constexpr double of_doubles = 1e-9;
            const std::string what =
                fmt::format("{}, part {}, {}", name, part, std::array{"light there", "light back", "Jacobians"}[q]);
            const double change = 2 * changes[j][q], scale = std::max(found[j][q], kept[q]);
            if (found[j] == nothing)
                cases.add(what, HUGE_VAL, change > 0 ? change : of_doubles);
            else
                cases.add(what, std::abs(found[j][q] - kept[q]) / scale, change / scale + of_doubles);
        }
    }
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

std::unique_ptr<PathShift> with_eta_of_base(const PathTracer& tracer) {
    auto shift = std::make_unique<HybridShift>(tracer);
    shift->eta_beyond = [](const PathStory::Scattering& onwards, const PathVertex&) { return onwards.eta; };
    return shift;
}

struct ThereAndBack {
    MakeShift there, back;
};

Verdict lead_back(const ThereAndBack& shifts, const Run& run) {
    const PathTracer tracer({.roulette_edges = 2});
    const auto forth = shifts.there(tracer), returning = shifts.back(tracer);
    HeldCases cases;
    const std::uint64_t seed = run.random(0).bits();
    for (const auto& [name, pixels] : shift_scenes()) {
        RoundTrip trip{pixels, *forth, *returning};
        for (std::uint32_t i = 0; i < run.pick(150u, 3'000u); ++i) {
            run.end_if_stopped();
            IndependentSamples numbers({seed, 0, i});
            trip.measure(fmt::format("{}, sample {}", name, i), numbers, cases);
        }
    }
    return cases.verdict();
}

}  // namespace

void add_shift_round_trips(Catalogue& catalogue) {
    catalogue.add(
        {.id = "shift/path/there-and-back",
         .statement = "From the numbers that lead to a shifted path `path` traces it, finds the same light in each "
                      "part, and its shift back is the base, with the reciprocal Jacobian, within "
                      "what rounding rays to floats can change.",
         .source = "ours, integrators/estimators/hybrid_shift.h",
         .kind = Kind::bounded,
         .trial = {lead_back,
                   {hybrid, hybrid},
                   {{"other-weights",
                     "Shifted light is weighted by the balance heuristic, traced light by the power.",
                     {weighted_by_balance, hybrid}},
                    {"eta-of-base",
                     "Behind the connection the index is that of the base, which may meet glass from the other side.",
                     {with_eta_of_base, with_eta_of_base}},
                    {"roulette-not-played", "Roulette is played for the base alone.", {without_roulette, hybrid}},
                    {"one-way",
                     "The Jacobian has its cosines on the way there alone.",
                     {hybrid, hybrid_by([](const Connection& c) { return c.pdf / (c.distance * c.distance); })}}}}});
}

}  // namespace plumb::suites
