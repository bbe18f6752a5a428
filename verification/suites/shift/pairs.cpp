// What shifts bring from one pixel to another, against what the other finds itself.
//
// Of two pixels i and j, a path y of j has the density 1 from j's own samples, and q(y) = |∂T_{j→i}/∂y| from those of
// i, shifted: 0 where T fails. The balance heuristic gives it 1/(1 + q) of its own sample, and q/(1 + q) of a shifted
// one, which estimates f(y)/q. Their sum has the mean ∫ f dy of j's own samples alone; so, of independent paths or not,
//   E[f(T(x)) J/(1 + J)] = E[f(y) q/(1 + q)],
// where J = 1/q is that of the shift from i to y. A draw is the difference of the two.
//
// That holds of any function of y in place of f. Where few paths bring most of the light, ours is bounded: of light L
// in part p it is 2^-p L/(L + s), of all parts together less than 2, so that the test is exact, and need not wait for
// draws to be nearly normal.

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

// Made where it is asked for: scenes are large, and the catalogue is listed more often than they are traced.
using MakePixelPair = PixelPair (*)();

// What is seen of the light of a path: all of it, or how bright each part is.
using Sight = double (*)(const std::vector<PartSplat>& splats, const std::vector<ShiftedPart>& parts, Share share);

struct Exchange {
    MakePixelPair pixels;
    MakeShift make = hybrid;
    Share share = balance;  // of a pixel's own paths
    Sight sight;
};

// Light of more than one edge: that is where shifts are used.
double shared_light(const std::vector<PartSplat>& splats, const std::vector<ShiftedPart>& parts, Share share) {
    double sum = 0;
    for (const PartSplat& splat : splats)
        if (splat.splat.edges > 1) sum += luminance(splat.splat.value) * share(parts[splat.part]);
    return sum;
}

double brightness(const std::vector<PartSplat>& splats, const std::vector<ShiftedPart>& parts, Share share) {
    constexpr double half = 0.05;  // s
    thread_local std::vector<double> light;
    light.assign(parts.size(), 0);
    for (const PartSplat& splat : splats)
        if (splat.splat.edges > 1) light[splat.part] += luminance(splat.splat.value);
    double sum = 0, scale = 1;
    for (std::size_t part = 0; part < parts.size(); ++part, scale /= 2)
        if (light[part] > 0) sum += scale * share(parts[part]) * light[part] / (light[part] + half);
    return sum;
}

double difference(const Exchange& exchange, const PathShift& shift, PrimarySamples& numbers) {
    thread_local BasePath base;
    thread_local ShiftedPath shifted;
    const auto& [scene, from, to] = exchange.pixels();
    shift.trace(scene, from, numbers, base);
    shift.shift(scene, base, to, numbers, shifted);
    const double brought = exchange.sight(shifted.splats, shifted.parts, balance);
    shift.trace(scene, to, numbers, base);
    shift.shift(scene, base, from, numbers, shifted);
    return brought - exchange.sight(base.splats, shifted.parts, exchange.share);
}

Verdict exchanges(const Exchange& exchange, double delta, const Run& run) {
    const PathTracer tracer;
    const auto shift = exchange.make(tracer);
    const bool bounded = exchange.sight == brightness;
    const auto draw = [&, paths = bounded ? 1u : 16u](RandomStream& random) {
        IndependentSamples numbers;
        const std::uint64_t seed = random.bits();
        double sum = 0;
        for (std::uint32_t i = 0; i < paths; ++i) {
            numbers.start({seed, 0, i});
            sum += difference(exchange, *shift, numbers);
        }
        return sum / paths;
    };
    MeanClaim claim{.reference = 0,
                    .delta = delta,
                    .epsilon = 1e-3 * delta,
                    .why_fewer = "sixteen pairs of paths a draw, of which none is rare"};
    if (bounded) claim.bounds = {-2, 2};
    return mean_is(draw, claim, run);
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
    MakePixelPair pixels;
    double delta;
    std::vector<Defect> defects;
    Sight sight = shared_light;
};

void add(Catalogue& catalogue, const PairClaim& claim) {
    const auto check = [delta = claim.delta](const Exchange& exchange, const Run& run) {
        return exchanges(exchange, delta, run);
    };
    std::vector<Wrong<Exchange>> wrong;
    for (const Defect& defect : claim.defects)
        wrong.push_back({defect.id, defect.defect, Exchange{claim.pixels, defect.make, defect.share, claim.sight}});
    catalogue.add({.id = "shift/path/pairs-" + claim.name,
                   .statement = "What shifted paths bring another pixel is what it leaves to them: " + claim.what + ".",
                   .source = "ours, verification/suites/shift/pairs.cpp; [Veach 1997, eq. 9.8]",
                   .kind = Kind::mean,
                   .trial = {check, Exchange{claim.pixels, hybrid, balance, claim.sight}, std::move(wrong)}});
}

}  // namespace

void add_shift_pairs(Catalogue& catalogue) {
    add(catalogue, {"box",
                    "a diffuse box lit by a rectangle, seen through a lens",
                    [] {
                        return PixelPair{box_scene(), {8, 20, 1, 1}, {20, 26, 1, 1}};
                    },
                    1.5e-3,
                    {dropped(), inverted(), no_cos(), no_distance(), weight_lost()}});
    add(catalogue, {"rough",
                    "rough metal, glass and plastic under a sky and a point light",
                    [] {
                        return PixelPair{rough_scene(), {4, 14, 8, 8}, {18, 18, 8, 8}};
                    },
                    2.5e-3,
                    {dropped(), inverted(), no_pdf(), by_path(), weight_lost()}});
    add(catalogue, {"metal",
                    "a shining wall, most of it met by paths that leave rough metal",
                    [] {
                        return PixelPair{metal_scene(), {14, 24, 1, 1}, {18, 20, 1, 1}};
                    },
                    3e-3,
                    {dropped(), inverted(), no_distance(), no_pdf(), by_path()}});
    add(catalogue, {"glass",
                    "a ball of glass and a mirror, behind which paths are connected later",
                    [] {
                        return PixelPair{glass_scene(PathClass::Source::surface), {1, 3, 6, 10}, {9, 3, 6, 10}};
                    },
                    2e-3,
                    {connected_early(), by_path(), weight_lost()},
                    brightness});
    add(catalogue, {"curtain",
                    "a curtain that lets half of the light through",
                    [] {
                        return PixelPair{curtain_scene(), {12, 18, 1, 1}, {20, 24, 1, 1}};
                    },
                    1e-3,
                    {dropped(), inverted(), no_distance(), by_path(), weight_lost()}});
}

}  // namespace plumb::suites
