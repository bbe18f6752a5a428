// Variances of means over point sets in closed form.
#include <cmath>

#include "estimators/mean_over.h"
#include "estimators/sobol.h"
#include "estimators/stratified.h"
#include "verification/ratio.h"
#include "verification/suites/defective_point_sets.h"
#include "verification/suites/suites.h"

namespace plumb {
namespace {

Verdict has_variance(const Generate<1>& generate, const Function<1>& f, std::uint64_t n, double variance,
                     double relative_delta, std::uint64_t replicates, const Run& run) {
    const auto draw = [&](RandomStream& random) { return mean_over<1>(generate(n, random), f).value; };
    return variance_is(draw, variance, relative_delta, replicates, run);
}

/// Of the stratified mean of e^x: n^-2 times the sum over strata of length h of E e^2x − (E e^x)².
double stratified_variance_of_exp(std::uint64_t n) {
    const double h = 1 / static_cast<double>(n);
    double sum = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
        const double mean = std::exp(h * static_cast<double>(i)) * std::expm1(h) / h;
        sum += std::exp(2 * h * static_cast<double>(i)) * std::expm1(2 * h) / (2 * h) - mean * mean;
    }
    return h * h * sum;
}

}  // namespace

void add_point_variance_claims(Catalogue& catalogue) {
    // 8 · 0.275 = 2.2: the jump lies at 0.2 of its stratum; filled to 0.88 only, at 0.227: variance + 9.8 %.
    const auto jump = [](const Generate<1>& generate) {
        return [=](const Run& run) {
            const auto f = [](const Point<1>& p) { return p[0] < 0.275 ? 1.0 : 0.0; };
            return has_variance(generate, f, 8, 0.2 * 0.8 / 64, 0.04, 100000, run);
        };
    };
    const auto strata = [](std::uint64_t n) { return n; };
    catalogue.add({
        .id = "points/stratified-1d/variance-jump",
        .statement =
            "The variance of the stratified mean of a jump at x0 is φ(1 − φ)/n², φ the fractional part of n x0.",
        .source = "ours, estimators/point_set_slopes.cpp",
        .kind = Kind::ratio,
        .check = jump(stratified_1d),
        .mutants = {{"short-jitter", "The jitter fills 88 % of a stratum.",
                     jump(left_part_of_strata<1>(stratified_1d, strata, 0.88))},
                    {"independent", "Independent points.", jump(independent_points<1>)}},
    });
    // A jitter that fills c = 0.93 of each stratum has 0.93² of its variance (to first order in 1/n): −13.5 %.
    const auto scrambled = [](const Generate<1>& generate) {
        return [=](const Run& run) {
            const auto f = [](const Point<1>& p) { return std::exp(p[0]); };
            return has_variance(generate, f, 8, stratified_variance_of_exp(8), 0.05, 50000, run);
        };
    };
    catalogue.add({
        .id = "points/sobol-owen-1d/variance",
        .statement =
            "2^k Owen-scrambled points of one axis are stratified points: the variance of their mean is the same.",
        .source = "ours, estimators/point_set_slopes.cpp",
        .kind = Kind::ratio,
        .check = scrambled(owen_sobol_1d),
        .mutants = {{"short-jitter", "Points fill 93 % of their strata.",
                     scrambled(left_part_of_strata<1>(owen_sobol_1d, strata, 0.93))},
                    {"same-flips-for-every-point", "Every point's digits are flipped alike.",
                     scrambled(xor_van_der_corput)}},
    });
}

}  // namespace plumb
