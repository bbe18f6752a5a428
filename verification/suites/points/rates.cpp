// These claims say how fast means over point sets converge. Jumps and kinks are moved at random from replicate to
// replicate: at a fixed place the variance follows its position between the strata.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "estimators/points/halton.h"
#include "estimators/points/latin_hypercube.h"
#include "estimators/points/mean_over.h"
#include "estimators/points/multi_jittered.h"
#include "estimators/points/random_shift.h"
#include "estimators/points/sobol.h"
#include "estimators/points/stratified.h"
#include "estimators/points/zero_two.h"
#include "verification/claim.h"
#include "verification/evidence/rate.h"
#include "verification/suites/points/defective_point_sets.h"

namespace plumb::suites {
namespace {

/// An integrand drawn anew for each replicate, with its integral.
template <int D>
struct Problem {
    Function<D> f;
    double integral;
};

const double e_minus_1 = std::numbers::e - 1;

Problem<1> exponential(RandomStream&) {
    return {[](const Point<1>& p) { return std::exp(p[0]); }, e_minus_1};
}

Problem<1> jump(RandomStream& random) {
    const double x0 = random.uniform();
    return {[x0](const Point<1>& p) { return p[0] < x0 ? 1.0 : 0.0; }, x0};
}

Problem<2> product(RandomStream&) {
    return {[](const Point<2>& p) { return std::exp(p[0] + p[1]); }, e_minus_1 * e_minus_1};
}

Problem<2> sum(RandomStream&) {
    return {[](const Point<2>& p) { return std::exp(p[0]) + std::exp(p[1]); }, 2 * e_minus_1};
}

Problem<2> upright_edge(RandomStream& random) {
    const double x0 = random.uniform();
    return {[x0](const Point<2>& p) { return p[0] < x0 ? 1.0 : 0.0; }, x0};
}

/// The line y = a + 0.37 x, a in [0.2, 0.5): it crosses the square from side to side.
constexpr double rise = 0.37;
double random_height(RandomStream& random) {
    return 0.2 + 0.3 * random.uniform();
}

Problem<2> oblique_edge(RandomStream& random) {
    const double a = random_height(random);
    return {[a](const Point<2>& p) { return p[1] < a + rise * p[0] ? 1.0 : 0.0; }, a + rise / 2};
}

/// max(0, a + 0.37 x − y), of integral ∫ (a + 0.37 x)²/2 dx.
Problem<2> oblique_kink(RandomStream& random) {
    const double a = random_height(random), b = a + rise;
    return {[a](const Point<2>& p) { return std::max(0.0, a + rise * p[0] - p[1]); },
            (b * b * b - a * a * a) / (6 * rise)};
}

template <int D>
struct Rate {
    std::string set, property, statement, source;
    Generate<D> generate;
    Problem<D> (*problem)(RandomStream&);
    std::string integrand;
    std::vector<std::uint64_t> n;
    std::uint64_t replicates;
    Interval exponents;
    std::vector<Wrong<Generate<D>>> others;  // sets of another rate
};

template <int D>
Verdict converges(const Rate<D>& rate, const Generate<D>& generate, const Run& run) {
    const Replicate error = [&](std::uint64_t n, RandomStream& random) {
        const auto [f, integral] = rate.problem(random);
        Estimate estimate = mean_over<D>(generate(n, random), f);
        estimate.value -= integral;
        return estimate;
    };
    return rate_is(error, {rate.set, rate.integrand, 0, rate.n, rate.replicates}, rate.exponents, run);
}

template <int D>
void add(Catalogue& catalogue, const Rate<D>& rate) {
    catalogue.add({
        .id = fmt::format("points/{}-{}d/{}", rate.set, D, rate.property),
        .statement = rate.statement,
        .source = rate.source,
        .kind = Kind::rate,
        .trial = {[rate](const Generate<D>& generate, const Run& run) { return converges<D>(rate, generate, run); },
                  rate.generate, rate.others},
    });
}

constexpr Interval around(double exponent, double half_width) {
    return {exponent - half_width, exponent + half_width};
}

/// The first point of the set is drawn anywhere: adds a variance of order n^-2.
template <int D>
Generate<D> first_point_anywhere(Generate<D> generate) {
    return [=](std::uint64_t n, RandomStream& random) {
        auto points = generate(n, random);
        for (double& x : points[0]) x = random.uniform();
        return points;
    };
}

std::vector<Point<1>> shifted_grid(std::uint64_t n, RandomStream& random) {
    return random_shift<1>(hammersley_1d(n), random);
}

const std::vector<std::uint64_t> powers_of_two{16, 32, 64, 128, 256}, squares{16, 64, 256, 1024};

void add_rates_1d(Catalogue& catalogue) {
    add<1>(catalogue, {.set = "stratified",
                       .property = "rate-smooth",
                       .statement = "The MSE of stratified means of e^x falls as n^-3.",
                       .source = "[Haber 1966]; estimators/points/point_set_slopes.cpp",
                       .generate = stratified_1d,
                       .problem = exponential,
                       .integrand = "e^x",
                       .n = powers_of_two,
                       .replicates = 2000,
                       .exponents = around(-3, 0.3),
                       .others = {{"first-point-anywhere", "The first point ignores its stratum.",
                                   first_point_anywhere<1>(stratified_1d)},
                                  {"independent", "Independent points.", independent_points<1>}}});
    add<1>(catalogue, {.set = "stratified",
                       .property = "rate-jump",
                       .statement = "The MSE of stratified means of a jump falls as n^-2.",
                       .source = "estimators/points/point_set_slopes.cpp",
                       .generate = stratified_1d,
                       .problem = jump,
                       .integrand = "jump at a random place",
                       .n = powers_of_two,
                       .replicates = 2000,
                       .exponents = around(-2, 0.3),
                       .others = {{"independent", "Independent points.", independent_points<1>}}});
    add<1>(catalogue,
           {.set = "sobol-owen",
            .property = "rate-smooth",
            .statement = "The MSE of Owen-scrambled means of e^x falls as n^-3, n = 2^k.",
            .source = "[Owen 1997]",
            .generate = owen_sobol_1d,
            .problem = exponential,
            .integrand = "e^x",
            .n = powers_of_two,
            .replicates = 2000,
            .exponents = around(-3, 0.3),
            .others = {{"same-flips-for-every-point",
                        "Every point's digits are flipped alike: uniform, but no averaging.", xor_van_der_corput}}});
    add<1>(catalogue, {.set = "hammersley-shifted",
                       .property = "rate-smooth",
                       .statement = "The MSE of means of e^x over a randomly shifted grid falls as n^-2 only.",
                       .source = "[Cranley & Patterson 1976]; estimators/points/point_set_slopes.cpp",
                       .generate = shifted_grid,
                       .problem = exponential,
                       .integrand = "e^x",
                       .n = powers_of_two,
                       .replicates = 2000,
                       .exponents = around(-2, 0.3),
                       .others = {{"stratified", "A jitter for each point.", stratified_1d}}});
}

void add_rates_stratified_2d(Catalogue& catalogue) {
    add<2>(catalogue, {.set = "stratified",
                       .property = "rate-smooth",
                       .statement = "The MSE of stratified means of e^(x+y) falls as n^-2.",
                       .source = "[Haber 1966]; estimators/points/point_set_slopes.cpp",
                       .generate = stratified_2d,
                       .problem = product,
                       .integrand = "e^(x+y)",
                       .n = squares,
                       .replicates = 1000,
                       .exponents = around(-2, 0.3),
                       .others = {{"latin-hypercube", "A Latin hypercube.", latin_hypercube_2d}}});
    add<2>(catalogue, {.set = "stratified",
                       .property = "rate-edge",
                       .statement = "The MSE of stratified means of an oblique edge falls as n^-1.5.",
                       .source = "estimators/points/point_set_slopes.cpp",
                       .generate = stratified_2d,
                       .problem = oblique_edge,
                       .integrand = "oblique edge at a random place",
                       .n = squares,
                       .replicates = 2000,
                       .exponents = around(-1.5, 0.15),
                       .others = {{"independent", "Independent points.", independent_points<2>}}});
}

void add_rates_latin_hypercube(Catalogue& catalogue) {
    add<2>(catalogue,
           {.set = "latin-hypercube",
            .property = "rate-additive",
            .statement = "The MSE of Latin hypercube means of e^x + e^y falls as n^-3.",
            .source = "[Stein 1987]",
            .generate = latin_hypercube_2d,
            .problem = sum,
            .integrand = "e^x + e^y",
            .n = powers_of_two,
            .replicates = 2000,
            .exponents = around(-3, 0.3),
            .others = {{"first-point-anywhere", "The first point ignores its column and row.",
                        first_point_anywhere<2>(latin_hypercube_2d)},
                       {"repeated-rows", "Rows are drawn independently.", latin_hypercube_with_repeated_rows}}});
    add<2>(catalogue, {.set = "latin-hypercube",
                       .property = "rate-product",
                       .statement = "The MSE of Latin hypercube means of e^(x+y) falls as n^-1 only.",
                       .source = "[Stein 1987]",
                       .generate = latin_hypercube_2d,
                       .problem = product,
                       .integrand = "e^(x+y)",
                       .n = powers_of_two,
                       .replicates = 2000,
                       .exponents = around(-1, 0.3),
                       .others = {{"stratified", "Stratified in two dimensions.", stratified_2d}}});
}

void add_rates_multi_jittered(Catalogue& catalogue) {
    add<2>(catalogue, {.set = "cmj",
                       .property = "rate-additive",
                       .statement = "The MSE of correlated multi-jittered means of e^x + e^y falls as n^-3.",
                       .source = "[Kensler 2013]; estimators/points/point_set_slopes.cpp",
                       .generate = correlated_multi_jittered_2d,
                       .problem = sum,
                       .integrand = "e^x + e^y",
                       .n = squares,
                       .replicates = 1000,
                       .exponents = around(-3, 0.3),
                       .others = {{"stratified", "Jittered in the cells, not multi-jittered.", stratified_2d}}});
    add<2>(catalogue,
           {.set = "cmj",
            .property = "rate-product",
            .statement =
                "The MSE of correlated multi-jittered means of e^(x+y) falls as n^-1.5 only, slower than stratified.",
            .source = "ours, estimators/points/point_set_slopes.cpp",
            .generate = correlated_multi_jittered_2d,
            .problem = product,
            .integrand = "e^(x+y)",
            .n = squares,
            .replicates = 1000,
            .exponents = around(-1.5, 0.2),
            .others = {{"stratified", "Jittered in the cells, independently.", stratified_2d},
                       {"uncorrelated",
                        "Multi-jittered with a permutation for each row and each column [Chiu, Shirley & Wang 1994].",
                        multi_jittered_uncorrelated}}});
}

void add_rates_scrambled_2d(Catalogue& catalogue) {
    add<2>(catalogue,
           {.set = "sobol-owen",
            .property = "rate-smooth",
            .statement = "The MSE of Owen-scrambled means of e^(x+y) falls as n^-3 log n, n = 2^k.",
            .source = "[Owen 1997]",
            .generate = owen_sobol_2d,
            .problem = product,
            .integrand = "e^(x+y)",
            .n = powers_of_two,
            .replicates = 2000,
            .exponents = around(-2.8, 0.25),
            .others = {{"same-flips-for-every-point",
                        "Every point's digits are flipped alike: uniform, but no averaging.", xor_zero_two}}});
    add<2>(catalogue, {.set = "sobol-owen",
                       .property = "rate-edge",
                       .statement = "The MSE of Owen-scrambled means of an oblique edge falls as n^-1.5, n = 2^k.",
                       .source = "estimators/points/point_set_slopes.cpp",
                       .generate = owen_sobol_2d,
                       .problem = oblique_edge,
                       .integrand = "oblique edge at a random place",
                       .n = powers_of_two,
                       .replicates = 2000,
                       .exponents = around(-1.5, 0.15),
                       .others = {{"independent", "Independent points.", independent_points<2>}}});
    add<2>(catalogue, {.set = "sobol-owen",
                       .property = "rate-upright-edge",
                       .statement = "The MSE of Owen-scrambled means of an edge along an axis falls as n^-2, n = 2^k.",
                       .source = "estimators/points/point_set_slopes.cpp",
                       .generate = owen_sobol_2d,
                       .problem = upright_edge,
                       .integrand = "upright edge at a random place",
                       .n = powers_of_two,
                       .replicates = 2000,
                       .exponents = around(-2, 0.2),
                       .others = {{"stratified", "Stratified in two dimensions.", stratified_2d}}});
    add<2>(catalogue, {.set = "sobol-owen",
                       .property = "rate-kink",
                       .statement = "The MSE of Owen-scrambled means of an oblique kink falls as n^-2.5, n = 2^k.",
                       .source = "ours, estimators/points/point_set_slopes.cpp",
                       .generate = owen_sobol_2d,
                       .problem = oblique_kink,
                       .integrand = "oblique kink at a random place",
                       .n = powers_of_two,
                       .replicates = 2000,
                       .exponents = around(-2.5, 0.2),
                       .others = {{"stratified", "Stratified in two dimensions.", stratified_2d}}});
}

}  // namespace

void add_points_rates(Catalogue& catalogue) {
    add_rates_1d(catalogue);
    add_rates_stratified_2d(catalogue);
    add_rates_latin_hypercube(catalogue);
    add_rates_multi_jittered(catalogue);
    add_rates_scrambled_2d(catalogue);
}

}  // namespace plumb::suites
