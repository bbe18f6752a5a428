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

#include "integrators/paths/vertex.h"
#include "verification/suites/shift/shift_subjects.h"
#include "verification/suites/suites.h"

namespace plumb::suites {
namespace {

// What `path` finds in a part from given numbers: its light, that of the shift back, and the product of both Jacobians.
// All of it is infinite where the part is not there.
using Found = std::array<double, 3>;
constexpr Found nothing{HUGE_VAL, HUGE_VAL, HUGE_VAL};

// By how much, relative to it, light changes where a traced edge has the direction in which its ray was sent, and a
// kept one that of the line between its vertices. Moving z does not show it: changes of cosines and of the distance may
// cancel there. Of a weight w = p²/(p² + q²) it is |d ln w| ≤ 2 |d ln p| + 2 |d ln q|; the density q of a light sample
// has 1/cos at z, and that of the BSDF, p, is told for a turned direction.
double change_by_direction(const PathVertex& from, const Connection& edge) {
    const double turn = edge.end ? ray_miss(from.hit.point, edge.end->hit.point) / edge.distance : ray_turn;
    const auto light = [&](Vec3 wi) { return std::log(luminance(eval_bsdf(from, wi, Transport::radiance))); };
    const Frame across(edge.direction);
    double most = 0;
    for (const Vec3 step : {across.x, -across.x, across.y, -across.y}) {
        const Vec3 wi = normalize(edge.direction + step * turn);
        most = std::max(most, 2 * std::abs(std::log(smooth_pdf(from, wi) / edge.pdf)) +
                                  std::abs(light(wi) - light(edge.direction)));
    }
    return most + 2 * turn * std::sqrt(1 / (edge.cos * edge.cos) - 1);
}

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
    [[nodiscard]] Connection edge_from(const PathRecord& record) const;
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

Connection RoundTrip::edge_from(const PathRecord& record) const {
    const std::size_t k = base.connection;
    const PathVertex& from = record.vertices[k - 1];
    if (base.record.vertices.size() <= k)
        return connection_to_environment(from, base.story.scatterings[k - 1].direction);
    return connection_to(pixels.scene, from, base.record.vertices[k].hit);
}

// The ray from y_k misses z by m_y across itself, and that from x_k missed by m_x, for which z moves on its tangent
// plane by up to m_x/cos θ_x. Where the ray from y_k moves by r across itself, z moves on the plane by r at least.
double RoundTrip::turn_at_connection() const {
    const auto& vertices = base.record.vertices;
    const std::size_t k = base.connection;
    if (vertices.size() <= k) return 2 * ray_turn;
    const SurfacePoint &x = vertices[k - 1].hit.point, &y = shifted.record.vertices[k - 1].hit.point,
                       &z = vertices[k].hit.point;
    const double cos_x = std::abs(dot(z.normal, normalize(z.position - x.position)));
    return (ray_miss(y, z) + ray_miss(x, z) / cos_x) / length(z.position - y.position);
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
    const std::array<double, 3> by_direction{
        change_by_direction(shifted.record.vertices[base.connection - 1], edge_from(shifted.record)),
        change_by_direction(base.record.vertices[base.connection - 1], edge_from(base.record)), 0};
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
                cases.add(what, std::abs(found[j][q] - kept[q]) / scale, change / scale + by_direction[q] + of_doubles);
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
