#include "reports/run/sample_results.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace plumb::reports {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// MSE = scale·n^slope with a little ripple in place of noise.
Series power_law(std::string estimator, std::string integrand, double scale, double slope, double nanoseconds,
                 std::optional<Interval> expected) {
    Series s{.estimator = std::move(estimator),
             .integrand = std::move(integrand),
             .replicates = 1000,
             .points = {},
             .slope = {slope + 0.02, 0.02, {slope - 0.02, slope + 0.06}},
             .expected_slope = expected};
    for (std::uint64_t n = 16; n <= 65536; n *= 4) {
        const auto samples = static_cast<double>(n);
        const double mse = scale * std::pow(samples, slope) * (1 + 0.08 * std::sin(3 * std::log(samples) + slope));
        s.points.push_back({.n = n,
                            .evaluations = samples,
                            .seconds = nanoseconds * 1e-9 * samples * std::log2(samples),
                            .mse = mse,
                            .mse_interval = {mse * 0.85, mse * 1.18},
                            .bias = 0.3 * std::sqrt(mse / 1000),
                            .bias_standard_error = std::sqrt(mse / 1000),
                            .log_mse_error = 0.08});
    }
    return s;
}

std::vector<Series> comparison(const std::string& integrand) {
    std::vector<Series> list = {
        power_law("independent", integrand, 0.24, -1, 4, Interval{-1, -1}),
        power_law("stratified", integrand, 0.3, -3, 5, Interval{-3, -3}),
        power_law("reweighted by g", integrand, 0.6, -2, 30, Interval{-2, -2}),
        power_law("torus Voronoi", integrand, 1.3, -2, 28, Interval{-2, -2}),
        power_law("torus Voronoi, tent", integrand, 80, -4, 29, Interval{-4, -4}),
        power_law("end-point control variate", integrand, 5, -3.9, 31, Interval{-4.1, -3.9}),
        power_law("Owen-scrambled Sobol", integrand, 0.2, -3.05, 40, Interval{-3, -3}),
        power_law("Halton, randomly shifted", integrand, 0.4, -1.8, 12, {}),
        power_law("Latin hypercube", integrand, 0.3, -2.98, 8, Interval{-3, -3}),
    };
    list[7].points[1].mse_interval.low = -1e-6;  // what a normal approximation can give
    list[3].points[4].mse_interval.high = infinity;
    return list;
}

Series exact_series() {
    Series s = power_law("end-point control variate", "linear", 0, -1, 30, {});
    s.slope = {};
    return s;
}

Stability g_over_its_corner_cases() {
    Stability s{.formula = "g(N, x), 1D", .axis = "x", .unit = "ulp", .bound = 8, .points = {}};
    for (int exponent = -1074; exponent < 0; exponent += 17) {
        const double error = 1.5 + 1.4 * std::sin(exponent * 0.7) + (exponent > -60 ? 2.0 : 0.0);
        s.points.push_back(
            {fmt::format("N = 10^{}, x = 2^{}", -exponent % 10, exponent), std::ldexp(1.0, exponent), error});
    }
    return s;
}

Stability balance_weights() {
    return {.formula = "balance heuristic",
            .axis = "",
            .unit = "ulp",
            .bound = 2,
            .points = {{"pdfs 1e-300 and 1e300", 0, 0.5},
                       {"both pdfs infinite", 0, infinity},
                       {"one pdf 0", 0, 0},
                       {"equal pdfs", 0, 1},
                       {"a thousand pdfs", 0, 3.2}}};
}

Stability telescoping_weights() {
    return {.formula = "telescoping weights",
            .axis = "k",
            .unit = "relative",
            .bound = 1e-12,
            .points = {{"k = 1", 1, 0}, {"k = 10", 10, 2.2e-16}, {"k = 100", 100, 7e-16}, {"k = 10000", 1e4, 3e-15}}};
}

ClaimResult mean_claim(std::string id, std::string statement, double bias, double delta, Outcome outcome) {
    const Interval around{bias - delta / 2, bias + delta / 2};
    return {.id = std::move(id),
            .statement = std::move(statement),
            .source = "ours, docs/statistics.md; decides [thesis, appendix A.2]",
            .kind = Kind::mean,
            .verdict = {.outcome = outcome,
                        .statistic = bias / (delta / 6),
                        .p_value = outcome == Outcome::refuted ? 3.1e-9 : 0.42,
                        .deviation = around,
                        .resolution = delta,
                        .samples = 1'834'112,
                        .reason = fmt::format("a bias of ±{} is excluded (risk 0.01)", delta),
                        .evidence = {{"mean", 1.71828 + bias},
                                     {"standard_error", delta / 6},
                                     {"reference", 1.718281828459045},
                                     {"risks", std::string("exact: bounded values")}},
                        .series = {},
                        .stability = {}},
            .alpha_share = 4.1e-7,
            .seconds = 0.213,
            .no_mutant = ""};
}

ClaimResult exact_claim(std::string id, std::string statement) {
    return {.id = std::move(id),
            .statement = std::move(statement),
            .source = "[thesis, eq. 4.6]",
            .kind = Kind::exact,
            .verdict = {.outcome = Outcome::holds,
                        .deviation = {0, 0},
                        .resolution = 0,
                        .samples = 8,
                        .reason = "all coefficients are equal for N = 1 … 8",
                        .evidence = {},
                        .series = {},
                        .stability = {}},
            .alpha_share = 0,
            .seconds = 0.004,
            .no_mutant = ""};
}

std::vector<ClaimResult> reweighting_claims() {
    std::vector<ClaimResult> claims = {
        exact_claim("reweighting/g/expected-cell-length",
                    "g(x) is N times the expected length of the Voronoi cell of a sample at x."),
        mean_claim("reweighting/torus/unbiased",
                   "On the torus Σ|V| f is unbiased for i.i.d. samples, in one dimension.", 2e-6, 1e-4, Outcome::holds),
        mean_claim("reweighting/torus/unbiased-2d", "The same in two dimensions.", -3e-5, 1e-4, Outcome::holds),
        mean_claim("reweighting/voronoi/biased", "Weights of clipped cells are biased: E = ∫ g f.", 2e-5, 8e-5,
                   Outcome::holds),
        mean_claim("reweighting/stratified/end-strata", "Stratified weights need g_s in the first & last stratum.",
                   7e-4, 1e-4, Outcome::refuted),
        mean_claim("reweighting/general-g/density-1-over-x",
                   "|V|/(g p) is unbiased where p <script>alert(1)</script> is steep.", 8e-5, 1e-4, Outcome::undecided),
    };
    ClaimResult rate =
        mean_claim("reweighting/torus-tent/rate", "The MSE of torus + tent falls as n⁻⁴ for smooth integrands.", 0.02,
                   0.25, Outcome::holds);
    rate.kind = Kind::rate;
    rate.verdict.series = comparison("exp");
    claims.push_back(rate);
    rate.id = "reweighting/torus-tent/rate-kink";
    rate.verdict.series = comparison("C0 kink");
    rate.verdict.series.resize(4);
    claims.push_back(rate);
    ClaimResult stable =
        exact_claim("reweighting/g/stable", "g is within 8 ulp of its value for all N up to 10⁹ and x down to 2⁻¹⁰⁷⁴.");
    stable.kind = Kind::bounded;
    stable.verdict.resolution = 8;
    stable.verdict.deviation = {0, 4.9};
    stable.verdict.stability = {g_over_its_corner_cases(), telescoping_weights()};
    claims.push_back(stable);
    return claims;
}

std::vector<ClaimResult> mis_claims() {
    ClaimResult weights =
        exact_claim("mis/balance/corners", "The balance heuristic is within 2 ulp in the overflow corners.");
    weights.kind = Kind::bounded;
    weights.verdict.outcome = Outcome::refuted;
    weights.verdict.deviation = {0, infinity};
    weights.verdict.resolution = 2;
    weights.verdict.stability = {balance_weights()};
    ClaimResult chi = mean_claim("mis/one-sample/distribution", "The technique is chosen with its probability.", 0,
                                 0.02, Outcome::holds);
    chi.kind = Kind::distribution;
    chi.verdict.deviation = {0, 0.013};
    chi.verdict.evidence = {
        {"chi_square", 98.2},
        {"cells", std::uint64_t{100}},
        {"counts", std::vector<double>{101, 97, 112, 88, 94, 105, 99, 100, 103, 98, 96, 107, 90, 110}},
        {"largest", infinity},
        {"not_measured", std::numeric_limits<double>::quiet_NaN()}};
    ClaimResult cost =
        exact_claim("mis/cutoff/cost", "The cutoff heuristic evaluates one pdf per technique and sample.");
    cost.kind = Kind::cost;
    cost.no_mutant = "the count is defined by the interface: there is no other way to call it";
    return {weights, chi, cost};
}

MutantResult mutant(const std::string& of, const std::string& id, std::string defect, double bias, bool killed) {
    ClaimResult judged = mean_claim(of, "", bias, 1e-4, killed ? Outcome::refuted : Outcome::undecided);
    return {.id = of + "/" + id,
            .of = of,
            .defect = std::move(defect),
            .verdict = judged.verdict,
            .killed = killed,
            .seconds = 0.03};
}

}  // namespace

Results sample_results() {
    Results results{
        .run = {.seed = 17'592'186'044'416'123'457ULL,
                .alpha = 1e-4,
                .threads = 2,
                .size = "quick",
                .version = "0.1.0",
                .started = "2025-01-31T23:59:59Z",
                .patterns = "",
                .shard = 1,
                .shards = 1,
                .selected = 0,
                .fingerprint = "00c0ffee00c0ffee",
                .finished = true,
                .seconds = 57.31},
        .claims = reweighting_claims(),
        .mutants = {mutant("reweighting/torus/unbiased", "clipped", "cells clipped to the interval, called periodic",
                           -6e-3, true),
                    mutant("reweighting/torus/unbiased", "n-minus-1", "N − 1 in place of N", 3e-4, true),
                    mutant("reweighting/voronoi/biased", "called-unbiased",
                           "the clipped weights are claimed \"unbiased\"", 2.4e-4, true),
                    mutant("mis/one-sample/distribution", "swapped", "the two probabilities are exchanged", 1.1e-4,
                           false)},
        .errata = {{"[thesis, appendix A.2]", "The periodic scheme is biased.",
                    "It is unbiased for every N and D: the law of a cell does not depend on where its sample lies.",
                    "reweighting/torus/unbiased"},
                   {"[thesis, section 4.3]", "The MSE falls as N^(−4/D) for reweighting by g.",
                    "It falls as N⁻² in 1D when f does not vanish at the ends.", "reweighting/torus-tent/rate"}},
        .series = {exact_series()}};
    for (ClaimResult& claim : mis_claims()) results.claims.push_back(std::move(claim));
    for (ClaimResult& claim : results.claims) claim.position = results.run.selected++;
    for (MutantResult& mutant : results.mutants) mutant.position = results.run.selected++;
    return results;
}

Results earlier_sample_results() {
    Results results = sample_results();
    results.run.started = "2025-01-30T08:00:00Z";
    results.run.seed = 7;
    results.claims[1].verdict.outcome = Outcome::undecided;
    const std::uint64_t position = results.claims.back().position;
    results.claims.pop_back();
    results.claims.push_back(exact_claim("mis/maximum/sums", "The maximum heuristic's weights sum to 1."));
    results.claims.back().position = position;
    results.mutants.pop_back();
    return results;
}

}  // namespace plumb::reports
