#include "verification/evidence/ratio.h"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/evidence/convergence.h"

namespace plumb {
namespace {

const Run run(2024, "ratio_test", 1e-6);
double uniform(RandomStream& random) {
    return random.uniform();
}
double mean_of_two(RandomStream& random) {
    return (random.uniform() + random.uniform()) / 2;
}

TEST(RatioIs, ComparesVarianceTimesCost) {
    EXPECT_EQ(ratio_is(mean_of_two, uniform, {.ratio = {0.45, 0.55}}, run).outcome, Outcome::holds);
    EXPECT_EQ(ratio_is(mean_of_two, uniform, {.ratio = {0.9, 1.1}, .cost_a = 2}, run).outcome, Outcome::holds);
    EXPECT_EQ(ratio_is(mean_of_two, uniform, {.ratio = {0.9, 1.1}}, run).outcome, Outcome::refuted);
}

TEST(RatioIs, ZeroSampleVarianceDecidesNothing) {
    const auto one = [](RandomStream&) { return 1.0; };
    EXPECT_EQ(ratio_is(one, uniform, {.ratio = {0, 1}}, run).outcome, Outcome::undecided);
}

TEST(RatioIs, RefutesValuesThatAreNotNumbers) {
    const auto nan = [](RandomStream& random) { return random.uniform() < 0.001 ? std::nan("") : random.uniform(); };
    const Verdict verdict = ratio_is(uniform, nan, {.ratio = {0.9, 1.1}}, run);
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    EXPECT_THAT(verdict.reason, testing::HasSubstr("of b is not a finite number"));
    EXPECT_EQ(variance_is(nan, 1.0 / 12, 0.1, 10000, run).outcome, Outcome::refuted);
}

TEST(RatioIs, OneReplicateDecidesNothing) {
    const RatioClaim one{.ratio = {0.5, 2}, .replicates = 1, .why_fewer = "for a test"};
    EXPECT_EQ(ratio_is(uniform, uniform, one, run).outcome, Outcome::undecided);
}

TEST(MseRatioIs, ComparesSeriesAtTheLastCount) {
    const auto error = [](double scale) {
        return [=](std::uint64_t n, RandomStream& random) {
            return Estimate{scale * (random.uniform() - 0.5) / static_cast<double>(n), HUGE_VAL, n};
        };
    };
    const auto measured = [&](double scale, std::uint64_t last) {
        return measure_convergence(error(scale), {"uniform", "nothing", 0, {2, last}, 5000}, run);
    };
    const Series one = measured(1, 8), half = measured(0.5, 8), other = measured(1, 16);
    EXPECT_EQ(mse_ratio_is(half, one, {0.2, 0.3}, run).outcome, Outcome::holds);
    EXPECT_EQ(mse_ratio_is(one, one, {0.2, 0.3}, run).outcome, Outcome::refuted);
    EXPECT_THROW(mse_ratio_is(one, other, {0.2, 0.3}, run), std::logic_error);
}

// Brighter by 30 once in 33,333: 10,000 values show a variance that is a quarter too small, three times in four.
TEST(VarianceIs, IsNotRefutedByValuesThatLackTheRare) {
    const double p = 3e-5, variance = 1.0 / 12 + 900 * p * (1 - p);
    const auto rare = [p](RandomStream& random) { return random.uniform() + (random.uniform() < p ? 30 : 0); };
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        EXPECT_EQ(variance_is(rare, variance, 0.1, 10000, plumb::Run(seed, "rare", 1e-6)).outcome, Outcome::undecided);
}

TEST(VarianceIs, SaysWhatItRestsOn) {
    EXPECT_THAT(variance_is(uniform, 1.0 / 12, 0.1, 10000, run).reason,
                testing::HasSubstr("values rarer than 1 in 4,096 could hide"));
    const Verdict verdict = variance_is(uniform, 1.0 / 12, 0.1, 10000, run, "between 0 and 1");
    EXPECT_EQ(verdict.samples, 10000u);
    EXPECT_EQ(verdict.evidence.back(), Field("rests_on", "between 0 and 1"));
}

TEST(VarianceIs, FindsTheVarianceOverNAtNTwo) {
    EXPECT_EQ(variance_is(uniform, 1.0 / 12, 0.1, 10000, run).outcome, Outcome::holds);
    EXPECT_EQ(variance_is(uniform, 1.0 / 24, 0.1, 10000, run).outcome, Outcome::refuted);
}

}  // namespace
}  // namespace plumb
