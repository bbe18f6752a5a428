// The chi-square on trial: its risks where they can be counted exactly (two cells: binomial sums) and by simulation.

#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/distributions.h"
#include "verification/evidence/mean.h"
#include "verification/suites/calibration/laws.h"

namespace plumb::suites {
namespace {

// ---- two cells, exactly ----

// The counts of the first of two cells for which a test says yes form an interval around what is expected.
struct Counts {
    std::int64_t first, last;
};

Counts counts_around(std::int64_t expected, std::int64_t n, const std::function<bool(std::int64_t)>& yes) {
    if (!yes(expected)) return {0, -1};
    const auto farthest = [&](std::int64_t end) {
        std::int64_t inside = expected, outside = end + (end < expected ? -1 : 1);
        while (std::abs(outside - inside) > 1) {
            const std::int64_t middle = inside + (outside - inside) / 2;
            (yes(middle) ? inside : outside) = middle;
        }
        return inside;
    };
    return {farthest(0), farthest(n)};
}

double probability(const Counts& counts, std::int64_t n, double p) {
    if (counts.last < counts.first) return 0;
    const boost::math::binomial law(static_cast<double>(n), p);
    const double below = counts.first > 0 ? cdf(law, static_cast<double>(counts.first - 1)) : 0;
    return std::max(cdf(law, static_cast<double>(counts.last)) - below, 0.0);
}

double probability_outside(const Counts& counts, std::int64_t n, double p) {
    const boost::math::binomial law(static_cast<double>(n), p);
    const double below = counts.first > 0 ? cdf(law, static_cast<double>(counts.first - 1)) : 0;
    const double above = counts.last < n ? cdf(complement(law, static_cast<double>(counts.last))) : 0;
    return below + above;
}

Outcome outcome_of_two_cells(std::int64_t count, std::int64_t n, const DistributionClaim& claim, double alpha) {
    const std::array<std::uint64_t, 2> counts{static_cast<std::uint64_t>(count), static_cast<std::uint64_t>(n - count)};
    return chi_square_verdict(counts, claim, alpha, beta_in_use).outcome;
}

std::int64_t nearest_count(std::int64_t n, double q) {
    return static_cast<std::int64_t>(std::llround(static_cast<double>(n) * q));
}

// False alarms over their level, with this many expected in the rarer cell.
Verdict two_cell_false_alarms(const std::function<double(double alpha)>& expected_count) {
    std::vector<BoundedCase> cases;
    for (const double alpha : {alpha_in_use / 10, alpha_in_use, 1e-4, 1e-2})
        for (const double q : {0.5, 0.1, 1e-2, 1e-4}) {
            const DistributionClaim claim{{q, 1 - q}, 1e-6};
            const auto n = static_cast<std::int64_t>(std::ceil(expected_count(alpha) / q));
            const Counts kept = counts_around(nearest_count(n, q), n, [&](std::int64_t k) {
                return outcome_of_two_cells(k, n, claim, alpha) != Outcome::refuted;
            });
            cases.push_back(
                {fmt::format("q = {:g}, alpha = {:.1e}", q, alpha), probability_outside(kept, n, q) / alpha, alpha});
        }
    return within_bound(cases, aim, "times the level");
}

using Holds = std::function<bool(std::int64_t count, std::int64_t n, const DistributionClaim&)>;

bool holds_as_shipped(std::int64_t count, std::int64_t n, const DistributionClaim& claim) {
    return outcome_of_two_cells(count, n, claim, alpha_in_use) == Outcome::holds;
}

// The noncentral chi-square as it stands: counts are taken to vary as if the claim were true.
bool holds_by_variance_of_the_claim(std::int64_t count, std::int64_t n, const DistributionClaim& claim) {
    const double q = claim.probabilities[0], size = static_cast<double>(n);
    const double z = (static_cast<double>(count) - size * q) / std::sqrt(size * q * (1 - q));
    return noncentrality_upper_bound(z * z, 1, beta_in_use) < size * claim.delta * claim.delta;
}

const std::vector<double> deltas = {0.02, 0.05, 0.2}, rare_cells = {0.5, 0.1, 1e-2, 1e-3};

// P(holds) when the density error is exactly delta, all of it in one cell.
Verdict two_cell_wrong_holds(const Holds& holds) {
    std::vector<BoundedCase> cases;
    for (const double delta : deltas)
        for (const double q : rare_cells)
            for (const double sign : {-1.0, 1.0}) {
                const double p = q + sign * delta * std::sqrt(q * (1 - q));
                if (p < 0 || p > 1) continue;
                const DistributionClaim claim{{q, 1 - q}, delta};
                const auto n = static_cast<std::int64_t>(distribution_samples(claim, alpha_in_use, beta_in_use));
                const Counts holding =
                    counts_around(nearest_count(n, q), n, [&](std::int64_t k) { return holds(k, n, claim); });
                cases.push_back(
                    {fmt::format("q = {:g}, p = {:.3g}", q, p), probability(holding, n, p) / beta_in_use, q});
            }
    return within_bound(cases, aim, "times the risk of 1 %");
}

// P(neither holds nor refuted) when the claim is true, at a fraction of the samples that are taken.
Verdict two_cell_undecided(double fraction) {
    std::vector<BoundedCase> cases;
    for (const double delta : deltas)
        for (const double q : rare_cells) {
            const DistributionClaim claim{{q, 1 - q}, delta};
            const auto n = static_cast<std::int64_t>(
                fraction * static_cast<double>(distribution_samples(claim, alpha_in_use, beta_in_use)));
            const auto region = [&](Outcome outcome, bool inside) {
                return counts_around(nearest_count(n, q), n, [&](std::int64_t k) {
                    return (outcome_of_two_cells(k, n, claim, alpha_in_use) == outcome) == inside;
                });
            };
            const double not_holding = probability_outside(region(Outcome::holds, true), n, q),
                         refuted = probability_outside(region(Outcome::refuted, false), n, q);
            cases.push_back({fmt::format("q = {:g}, delta = {:g}", q, delta), std::max(not_holding - refuted, 0.0), q});
        }
    return within_bound(cases, 1e-5, "probability");
}

void add_exact_claims(Catalogue& catalogue) {
    catalogue.add({.id = "calibration/false-alarms/two-cells",
                   .statement = "With expected counts of (z³/4)², z the level's quantile, the chi-square of two cells "
                                "refutes a true density at most 1.3 times as often as its level, down to 1e-7.",
                   .source = "binomial sums over all counts; docs/statistics.md, Distributions",
                   .kind = Kind::bounded,
                   .trial = {two_cell_false_alarms,
                             least_expected_count,
                             {{"hundred", "an expected count of 100 whatever the level", [](double) { return 100.0; }},
                              {"five", "the textbook's expected count of 5", [](double) { return 5.0; }}}}});
    catalogue.add({.id = "calibration/wrong-holds/two-cells",
                   .statement = "A density error of exactly delta, all in one cell, ends in `holds` in at most 1.3 % "
                                "of the runs, however rare the cell.",
                   .source = "binomial sums over all counts; docs/statistics.md, Distributions",
                   .kind = Kind::bounded,
                   .trial = {two_cell_wrong_holds,
                             holds_as_shipped,
                             {{"variance-of-the-claim",
                               "the noncentral chi-square's bound without the allowance for "
                               "the variance of a cell that is too likely",
                               holds_by_variance_of_the_claim}}}});
    catalogue.add(
        {.id = "calibration/undecided/two-cells",
         .statement = "A true density of two cells stays undecided with a probability of at most 1e-5.",
         .source = "binomial sums over all counts; docs/statistics.md, Distributions",
         .kind = Kind::bounded,
         .trial = {
             two_cell_undecided, 1, {{"half-the-samples", "half of the samples that the design asks for", 0.5}}}});
}

// ---- four cells, by simulation ----

const DistributionClaim four_cells{{0.25, 0.25, 0.25, 0.25}, 0.2};

// The verdict on how often the p-value of a true density lies below 1 %, for the smallest expected count that is
// allowed.
Verdict four_cell_false_alarms(int degrees_of_freedom, const Run& run) {
    constexpr double level = 0.01;
    const auto draw = [&](RandomStream& random) {
        std::array<std::uint64_t, 4> counts{};
        for (int i = 0; i < 400; ++i) ++counts[random.bits() >> 62];
        return chi_square_verdict(counts, four_cells, level, beta_in_use, degrees_of_freedom).outcome ==
                       Outcome::refuted
                   ? 1.0
                   : 0.0;
    };
    return mean_at_most(draw, {.bound = aim * level, .margin = (aim - 1) * level, .bounds = {0, 1}}, run);
}

// The verdict on how often a density error of exactly delta ends in `holds`.
Verdict four_cell_wrong_holds(double error_of_density, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        std::array<std::uint64_t, 4> counts{};
        for (int i = 0; i < 1500; ++i) {  // phi = error: half the cells too likely by that fraction
            const bool low = random.uniform() < 0.5 * (1 + error_of_density);
            ++counts[(low ? 0 : 2) + random.below(2)];
        }
        return chi_square_verdict(counts, four_cells, alpha_in_use, beta_in_use).outcome == Outcome::holds ? 1.0 : 0.0;
    };
    return mean_at_most(draw, {.bound = aim * beta_in_use, .margin = 0.5 * beta_in_use, .bounds = {0, 1}}, run);
}

void add_simulated_claims(Catalogue& catalogue) {
    catalogue.add(
        {.id = "calibration/p-values/chi-square",
         .statement = "At an expected count of 100 the chi-square's p-value lies below 1 % in at most 1.3 % "
                      "of the runs.",
         .source = "docs/statistics.md, Distributions",
         .kind = Kind::mean,
         .trial = {four_cell_false_alarms, 3, {{"degrees-of-freedom-off-by-one", "cells − 2 degrees of freedom", 2}}}});
    catalogue.add(
        {.id = "calibration/wrong-holds/four-cells",
         .statement = "A density error phi of exactly delta, spread over four cells, ends in `holds` in at "
                      "most 1.3 % of the runs.",
         .source = "noncentral chi-square; docs/statistics.md, Distributions",
         .kind = Kind::mean,
         .trial = {four_cell_wrong_holds,
                   0.2,
                   {{"three-quarters-of-delta", "a density error of 0.75 delta passed off as delta", 0.15}}}});
}

}  // namespace

void add_calibration_fixed(Catalogue& catalogue) {
    add_exact_claims(catalogue);
    add_simulated_claims(catalogue);
}

}  // namespace plumb::suites
