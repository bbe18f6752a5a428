// Variances of means over point sets in closed form.
#include <cmath>

#include "core/moments.h"
#include "estimators/points/mean_over.h"
#include "estimators/points/multi_jittered.h"
#include "estimators/points/sobol.h"
#include "estimators/points/stratified.h"
#include "verification/claim.h"
#include "verification/evidence/ratio.h"
#include "verification/suites/points/defective_point_sets.h"

namespace plumb::suites {
namespace {

Verdict has_variance(const Generate<1>& generate, const Function<1>& f, std::uint64_t n, double variance,
                     double relative_delta, std::uint64_t replicates, const Run& run) {
    const auto draw = [&](RandomStream& random) { return mean_over<1>(generate(n, random), f).value; };
    return variance_is(draw, variance, relative_delta, replicates, run, "means of values between 0 and e");
}

/// The variance of the stratified mean of e^x: n^-2 times the sum over strata of length h of E e^2x − (E e^x)².
double stratified_variance_of_exp(std::uint64_t n) {
    const double h = 1 / static_cast<double>(n);
    double sum = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
        const double mean = std::exp(h * static_cast<double>(i)) * std::expm1(h) / h;
        sum += std::exp(2 * h * static_cast<double>(i)) * std::expm1(2 * h) / (2 * h) - mean * mean;
    }
    return h * h * sum;
}

std::uint64_t one_each(std::uint64_t n) {
    return n;
}

/// The variance of the correlated multi-jittered mean of e^(x+y), n = m². A point of cell (i, j) lies at
/// x = i/m + σ(j)/n plus a jitter within 1/n, and likewise in y, so that given the permutations the sum over the set
/// has the mean
///   G² A(τ) B(σ),  A(τ) = Σ_i a_i b_τ(i),  a_i = e^(i/m),  b_k = e^(k/n),  G = E e^jitter,
/// B likewise and independent of A. For a uniform permutation Var A = Σ(a − ā)² Σ(b − b̄)² / (m − 1) [Hoeffding 1951].
/// The jitters add S² − G⁴ a cell, S = E e^(2 jitter), times the squares of the same exponentials.
double multi_jittered_variance_of_exp(std::uint64_t m) {
    const double size = static_cast<double>(m), n = size * size;
    Moments a, b, a_squared, b_squared;
    for (std::uint64_t i = 0; i < m; ++i) {
        const double at = std::exp(static_cast<double>(i) / size), bt = std::exp(static_cast<double>(i) / n);
        a.add(at);
        b.add(bt);
        a_squared.add(at * at);
        b_squared.add(bt * bt);
    }
    const double mean = size * a.mean() * b.mean(), variance = (size - 1) * a.variance() * b.variance();
    const double of_permutations = variance * (variance + 2 * mean * mean);
    const double g = n * std::expm1(1 / n), s = n / 2 * std::expm1(2 / n);
    const double squares = size * a_squared.mean() * b_squared.mean();
    return (g * g * g * g * of_permutations + (s * s - g * g * g * g) * squares * squares) / (n * n);
}

void add_stratified(Catalogue& catalogue) {
    // 8 · 0.275 = 2.2: the jump lies at 0.2 of its stratum; filled to 0.88 only, at 0.227: variance + 9.8 %.
    const auto jump = [](const Generate<1>& generate, const Run& run) {
        const auto f = [](const Point<1>& p) { return p[0] < 0.275 ? 1.0 : 0.0; };
        return has_variance(generate, f, 8, 0.2 * 0.8 / 64, 0.04, 100000, run);
    };
    catalogue.add({
        .id = "points/stratified-1d/variance-jump",
        .statement =
            "The variance of the stratified mean of a jump at x0 is φ(1 − φ)/n², φ the fractional part of n x0.",
        .source = "ours, estimators/points/point_set_slopes.cpp",
        .kind = Kind::ratio,
        .trial = {jump,
                  stratified_1d,
                  {{"short-jitter", "The jitter fills 88 % of a stratum.",
                    left_part_of_strata<1>(stratified_1d, one_each, 0.88)},
                   {"independent", "Independent points.", independent_points<1>}}},
    });
}

void add_scrambled(Catalogue& catalogue) {
    // A jitter that fills c = 0.93 of each stratum has 0.93² of its variance (to first order in 1/n): −13.5 %.
    const auto scrambled = [](const Generate<1>& generate, const Run& run) {
        const auto f = [](const Point<1>& p) { return std::exp(p[0]); };
        return has_variance(generate, f, 8, stratified_variance_of_exp(8), 0.05, 50000, run);
    };
    catalogue.add({
        .id = "points/sobol-owen-1d/variance",
        .statement =
            "2^k Owen-scrambled points of one axis are stratified points: the variance of their mean is the same.",
        .source = "ours, estimators/points/point_set_slopes.cpp",
        .kind = Kind::ratio,
        .trial = {scrambled,
                  owen_sobol_1d,
                  {{"short-jitter", "Points fill 93 % of their strata.",
                    left_part_of_strata<1>(owen_sobol_1d, one_each, 0.93)},
                   {"same-flips-for-every-point", "Every point's digits are flipped alike.", xor_van_der_corput}}},
    });
}

void add_multi_jittered(Catalogue& catalogue) {
    const auto check = [](const Generate<2>& generate, const Run& run) {
        const Function<2> f = [](const Point<2>& p) { return std::exp(p[0] + p[1]); };
        const auto draw = [&](RandomStream& random) { return mean_over<2>(generate(64, random), f).value; };
        return variance_is(draw, multi_jittered_variance_of_exp(8), 0.15, 8000, run,
                           "means of values between 1 and e²");
    };
    catalogue.add({
        .id = "points/cmj-2d/variance",
        .statement = "The variance of the correlated multi-jittered mean of e^(x+y), n = 64, is that of two random "
                     "permutations and 64 jitters; the permutations' part is of order n^-1.5.",
        .source = "ours, verification/suites/points/variances.cpp",
        .kind = Kind::ratio,
        .trial = {check,
                  correlated_multi_jittered_2d,
                  {{"rows-not-correlated", "The rows have a permutation each, the columns share one.",
                    multi_jittered_half_correlated},
                   {"uncorrelated",
                    "Each row and each column has a permutation of its own [Chiu, Shirley & Wang 1994].",
                    multi_jittered_uncorrelated}}},
    });
}

}  // namespace

void add_points_variances(Catalogue& catalogue) {
    add_stratified(catalogue);
    add_scrambled(catalogue);
    add_multi_jittered(catalogue);
}

}  // namespace plumb::suites
