// Known holes of other test suites. Each claim is a defect that ours must see; each mutant is a test with the hole.

#include <cmath>
#include <numeric>

#include "core/moments.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/distribution.h"
#include "verification/evidence/distributions.h"
#include "verification/evidence/mean.h"

namespace plumb::suites {
namespace {

// The level of the tests with holes: so small that no accident gives them away.
constexpr double their_level = 1e-6;

Verdict rejected(bool yes, std::string reason) {
    Verdict verdict;
    verdict.outcome = yes ? Outcome::refuted : Outcome::holds;
    verdict.reason = std::move(reason);
    return verdict;
}

Moments moments_of(const Draw& draw, int count, const Run& run) {
    Moments moments;
    for (int i = 0; i < count; ++i) {
        RandomStream random = run.random(static_cast<std::uint64_t>(i));
        moments.add(draw(random));
    }
    return moments;
}

// Tests are what is judged here: each must refute what is wrong, ours as well as theirs. Wrapped, since a bare test
// could pass for the claim's check.
struct TestOnTrial {
    Verdict (*test)(const Run&);
};

Verdict sees(const TestOnTrial& subject, const Run& run) {
    return outcome_is(subject.test(run), Outcome::refuted);
}

void add(Catalogue& catalogue, std::string id, std::string statement, Kind kind, TestOnTrial ours, std::string hole,
         std::string defect, TestOnTrial theirs) {
    catalogue.add({.id = "calibration/holes/" + id,
                   .statement = std::move(statement),
                   .source = "docs/statistics.md, Holes of other suites",
                   .kind = kind,
                   .trial = {sees, ours, {{std::move(hole), std::move(defect), theirs}}}});
}

// ---- means ----

// Uniform in [0, 1e-4), said to have a mean that is 4 % larger: 3.5e-2 standard deviations.
constexpr double unit = 1e-4, wrong_mean = 0.52 * unit;
double small_values(RandomStream& random) {
    return unit * random.uniform();
}

Verdict small_mean(const Run& run) {
    return mean_is(small_values, {.reference = wrong_mean, .delta = 0.01 * unit, .bounds = {0, unit}}, run);
}

Verdict small_mean_with_floored_variance(const Run& run) {
    const Moments moments = moments_of(small_values, 100000, run);
    const double variance = std::max(moments.variance(), 1e-5);
    const double t = (moments.mean() - wrong_mean) / std::sqrt(variance / 100000);
    return rejected(normal_two_sided_tail(t) < their_level, fmt::format("t = {:.3g}", t));
}

double uniform(RandomStream& random) {
    return random.uniform();
}

// A mean 2 % too large, under twenty seeds: every one must refute it.
Verdict every_seed(const Run& run) {
    Verdict last;
    for (int seed = 0; seed < 20; ++seed) {
        last = mean_is(uniform, {.reference = 0.51, .delta = 0.005, .bounds = {0, 1}},
                       run.part(fmt::format("{}", seed), 0.05));
        if (last.outcome != Outcome::refuted) return last;
    }
    return last;
}

Verdict until_green(const Run& run) {
    for (int seed = 0; seed < 20; ++seed) {
        const Moments moments = moments_of(uniform, 2000, run.part(fmt::format("{}", seed)));
        const double z = (moments.mean() - 0.51) / moments.standard_error();
        if (normal_two_sided_tail(z) > 0.05)
            return rejected(false, fmt::format("green at seed {}: z = {:.3g}", seed, z));
    }
    return rejected(true, "twenty seeds failed");
}

// 400 tiles of which one is 10 % too bright.
constexpr int tiles = 400;
Draw tile(int number) {
    return [number](RandomStream& random) { return (number == 137 ? 1.1 : 1.0) * random.uniform(); };
}

Verdict every_tile(const Run& run) {
    std::vector<Verdict> verdicts;
    for (int t = 0; t < tiles; ++t) {
        const MeanClaim claim{.reference = 0.5, .delta = 0.025, .bounds = {0, 1.1}};
        verdicts.push_back(mean_is(tile(t), claim, run.part(fmt::format("{}", t), 1.0 / tiles)));
    }
    return all_of(std::move(verdicts));
}

Verdict tiles_with_slack(const Run& run) {
    int wrong = 0;
    for (int t = 0; t < tiles; ++t) {
        const Moments moments = moments_of(tile(t), 4000, run.part(fmt::format("{}", t)));
        wrong += normal_two_sided_tail((moments.mean() - 0.5) / moments.standard_error()) < their_level / tiles;
    }
    return rejected(wrong > 0.0025 * tiles, fmt::format("{} of {} tiles differ", wrong, tiles));
}

// ---- distributions ----

// 1 % of the mass leaks into the last cells, which were to have 1e-4 each.
DistributionClaim with_a_tail() {
    DistributionClaim claim{{0.4995, 0.4995}, 0.03};
    for (int i = 0; i < 10; ++i) claim.probabilities.push_back(1e-4);
    return claim;
}

std::size_t leaking(RandomStream& random) {
    return random.uniform() < 0.01 ? 2 + random.below(10) : random.below(2);
}

Verdict leak(const Run& run) {
    return distribution_is(leaking, with_a_tail(), run);
}

// Cells are pooled, smallest first, until 5 are expected; a last pool with fewer is dropped.
Verdict leak_with_dropped_pool(const Run& run) {
    constexpr int n = 4000;
    const DistributionClaim claim = with_a_tail();
    std::vector<double> counts(claim.probabilities.size());
    for (int i = 0; i < n; ++i) {
        RandomStream random = run.random(static_cast<std::uint64_t>(i));
        ++counts[leaking(random)];
    }
    double chi_square = 0, freedom = -1, pooled_expected = 0, pooled_count = 0;
    for (std::size_t cell = counts.size(); cell-- > 0;) {
        pooled_expected += n * claim.probabilities[cell];
        pooled_count += counts[cell];
        if (cell > 1 || pooled_expected <= 5) {
            if (cell == 2) pooled_expected = pooled_count = 0;  // the tail's pool: 4 expected
            continue;
        }
        chi_square += std::pow(pooled_count - pooled_expected, 2) / pooled_expected;
        pooled_expected = pooled_count = 0;
        ++freedom;
    }
    const double p = chi_square_tail(chi_square, freedom);
    return rejected(p < their_level, fmt::format("chi-square {:.3g}, p = {:.2g}", chi_square, p));
}

// A sampler that fails in 2 % of its calls, which its density does not admit: failures are the fifth cell.
std::size_t failing(RandomStream& random) {
    return random.uniform() < 0.02 ? 4 : random.below(4);
}

Verdict lost_mass(const Run& run) {
    return distribution_is(failing, {{0.25, 0.25, 0.25, 0.25, 0}, 0.05}, run);
}

Verdict lost_mass_ignored(const Run& run) {
    std::array<std::uint64_t, 4> counts{};
    for (std::uint64_t i = 0; i < 40000; ++i) {
        RandomStream random = run.random(i);
        if (const std::size_t cell = failing(random); cell < 4) ++counts[cell];
    }
    return chi_square_verdict(counts, {{0.25, 0.25, 0.25, 0.25}, 0.05}, their_level, 0.01);
}

}  // namespace

void add_calibration_holes(Catalogue& catalogue) {
    add(catalogue, "small-values", "A mean of 5e-5 that is claimed 4 % too large is refuted, small as its variance is.",
        Kind::mean, {small_mean}, "floored-variance", "a t-test whose variance is at least 1e-5",
        {small_mean_with_floored_variance});
    add(catalogue, "every-seed", "A mean that is 2 % off is refuted under each of twenty seeds.", Kind::mean,
        {every_seed}, "until-green", "fresh seeds are tried until a 5 % test of 2000 values passes", {until_green});
    add(catalogue, "one-tile", "One tile of 400 that is 10 % too bright is found.", Kind::mean, {every_tile},
        "quarter-percent-slack", "0.25 % of the tiles may fail after the correction for their number",
        {tiles_with_slack});
    add(catalogue, "leak", "A leak of 1 % into ten rare cells is seen.", Kind::distribution, {leak}, "dropped-pool",
        "a last pool with an expectation of at most 5 is dropped", {leak_with_dropped_pool});
    add(catalogue, "lost-mass", "A sampler that fails in 2 % of its calls is refuted.", Kind::distribution, {lost_mass},
        "successes-only", "only the samples that succeeded are tested", {lost_mass_ignored});
}

}  // namespace plumb::suites
