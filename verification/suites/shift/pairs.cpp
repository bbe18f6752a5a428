// What shifts bring from one pixel to another, against what the other finds itself.
//
// Of two pixels i and j, a path y of j has the density 1 from j's own samples, and q(y) = |∂T_{j→i}/∂y| from those of
// i, shifted: 0 where T fails. The balance heuristic gives it 1/(1 + q) of its own sample, and q/(1 + q) of a shifted
// one, which estimates f(y)/q. Their sum has the mean ∫ f dy of j's own samples alone; so, of independent paths or not,
//   E[f(T(x)) J/(1 + J)] = E[f(y) q/(1 + q)],
// where J = 1/q is that of the shift from i to y. A draw is the difference of the two.

#include "integrators/paths/limits.h"
#include "verification/evidence/mean.h"
#include "verification/suites/shift/shift_subjects.h"
#include "verification/suites/suites.h"

namespace plumb::suites {
namespace {

// What share of a part its pixel leaves to the path that it is shifted to.
using Share = double (*)(const ShiftedPart& part);

double balance(const ShiftedPart& part) {
    return part.valid() ? part.jacobian / (1 + part.jacobian) : 0;
}
double given_away(const ShiftedPart& part) {
    return part.valid() ? balance(part) : 0.5;
}

struct Exchange {
    PixelPair pixels;
    MakeShift make = hybrid;
    Share share = balance;  // of a pixel's own paths
};

// Light of more than one edge: that is where shifts are used.
double shared_light(const std::vector<PartSplat>& splats, const std::vector<ShiftedPart>& parts, Share share) {
    double sum = 0;
    for (const PartSplat& splat : splats)
        if (splat.splat.edges > 1) sum += luminance(splat.splat.value) * share(parts[splat.part]);
    return sum;
}

double difference(const Exchange& exchange, const PathShift& shift, PrimarySamples& numbers) {
    thread_local BasePath base;
    thread_local ShiftedPath shifted;
    const auto& [scene, from, to] = exchange.pixels;
    shift.trace(scene, from, numbers, base);
    shift.shift(scene, base, to, numbers, shifted);
    const double brought = shared_light(shifted.splats, shifted.parts, balance);
    shift.trace(scene, to, numbers, base);
    shift.shift(scene, base, from, numbers, shifted);
    return brought - shared_light(base.splats, shifted.parts, exchange.share);
}

Verdict exchanges(const Exchange& exchange, double delta, const Run& run) {
    const PathTracer tracer;
    const auto shift = exchange.make(tracer);
    const auto draw = [&](RandomStream& random) {
        constexpr std::uint32_t paths = 16;
        IndependentSamples numbers;
        const std::uint64_t seed = random.bits();
        double sum = 0;
        for (std::uint32_t i = 0; i < paths; ++i) {
            numbers.start({seed, 0, i});
            sum += difference(exchange, *shift, numbers);
        }
        return sum / paths;
    };
    return mean_is(draw,
                   {.reference = 0,
                    .delta = delta,
                    .epsilon = 1e-3 * delta,
                    .why_fewer = "sixteen pairs of paths a draw, of which none is rare"},
                   run);
}

// ---- Jacobians with a defect

double one(const Connection&) {
    return 1;
}
double inverse_density(const Connection& c) {
    return 1 / connection_density(c);
}
double inverse_beyond(const Connection& c) {
    return 1 / density_beyond(c);
}
double without_cos(const Connection& c) {
    return c.pdf / (c.distance * c.distance);
}
double without_distance(const Connection& c) {
    return c.pdf * c.cos;
}
double without_pdf(const Connection& c) {
    return c.cos / (c.distance * c.distance);
}

struct Defect {
    std::string id, defect;
    MakeShift make = hybrid;
    Share share = balance;
};
Defect dropped() {
    return {"dropped", "The Jacobian is 1.", hybrid_by(one, one)};
}
Defect inverted() {
    return {"inverted", "The Jacobian is that of the shift back.", hybrid_by(inverse_density, inverse_beyond)};
}
Defect no_cos() {
    return {"no-cos", "The Jacobian lacks the cosines at the far end.", hybrid_by(without_cos)};
}
Defect no_distance() {
    return {"no-distance", "The Jacobian lacks the squared distances.", hybrid_by(without_distance)};
}
Defect no_pdf() {
    return {"no-pdf", "The Jacobian lacks the ratio of densities at the connection.", hybrid_by(without_pdf)};
}
Defect by_path() {
    return {"validity-by-path", "A part that fails fails its whole path.", valid_by_path};
}
Defect connected_early() {
    return {"asymmetric", "A path is connected where its shift back would be connected earlier.", asymmetric};
}
Defect weight_lost() {
    return {"weight-given-away", "A pixel leaves half of a path to a shift that fails.", hybrid, given_away};
}

struct PairClaim {
    std::string name, what;
    PixelPair pixels;
    double delta;
    std::vector<Defect> defects;
};

void add(Catalogue& catalogue, const PairClaim& claim) {
    const auto check = [delta = claim.delta](const Exchange& exchange, const Run& run) {
        return exchanges(exchange, delta, run);
    };
    std::vector<Wrong<Exchange>> wrong;
    for (const Defect& defect : claim.defects)
        wrong.push_back({defect.id, defect.defect, Exchange{claim.pixels, defect.make, defect.share}});
    catalogue.add({.id = "shift/path/pairs-" + claim.name,
                   .statement = "What shifted paths bring another pixel is what it leaves to them: " + claim.what + ".",
                   .source = "ours, verification/suites/shift/pairs.cpp; [Veach 1997, eq. 9.8]",
                   .kind = Kind::mean,
                   .trial = {check, Exchange{claim.pixels, hybrid, balance}, std::move(wrong)}});
}

}  // namespace

void add_shift_pairs(Catalogue& catalogue) {
    add(catalogue, {"box",
                    "a diffuse box lit by a rectangle, seen through a lens",
                    {box_scene(), {8, 20, 1, 1}, {20, 26, 1, 1}},
                    1.5e-3,
                    {dropped(), inverted(), no_cos(), no_distance(), weight_lost()}});
    add(catalogue, {"rough",
                    "rough metal, glass and plastic under a sky and a point light",
                    {rough_scene(), {4, 14, 8, 8}, {18, 18, 8, 8}},
                    2.5e-3,
                    {dropped(), inverted(), no_pdf(), by_path(), weight_lost()}});
    add(catalogue, {"metal",
                    "a shining wall, most of it met by paths that leave rough metal",
                    {metal_scene(), {14, 24, 1, 1}, {18, 20, 1, 1}},
                    3e-3,
                    {dropped(), inverted(), no_distance(), no_pdf(), by_path()}});
    add(catalogue, {"glass",
                    "a ball of glass and a mirror, behind which paths are connected later",
                    {glass_scene(PathClass::Source::surface), {1, 3, 6, 10}, {9, 3, 6, 10}},
                    5e-3,
                    {connected_early(), by_path(), weight_lost()}});
    add(catalogue, {"curtain",
                    "a curtain that lets half of the light through",
                    {curtain_scene(), {12, 18, 1, 1}, {20, 24, 1, 1}},
                    1e-3,
                    {dropped(), inverted(), no_distance(), by_path(), weight_lost()}});
}

}  // namespace plumb::suites
