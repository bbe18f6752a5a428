#include "verification/evidence/mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <mutex>

#include "verification/evidence/rare_values.h"

namespace plumb {
namespace {

using testing::HasSubstr;

const Run run(2024, "mean_test", 1e-6);
double uniform(RandomStream& random) {
    return random.uniform();
}

TEST(MeanIs, HoldsForATrueMean) {
    const Verdict verdict = mean_is(uniform, {.reference = 0.5, .delta = 0.01, .bounds = {0, 1}}, run);
    EXPECT_EQ(verdict.outcome, Outcome::holds) << verdict.reason;
    EXPECT_GT(verdict.p_value, run.alpha());
    EXPECT_TRUE(verdict.deviation.contains(0));
}

TEST(MeanIs, RefutesABiasOfTwoDelta) {
    const Verdict verdict = mean_is(uniform, {.reference = 0.52, .delta = 0.01, .bounds = {0, 1}}, run);
    EXPECT_EQ(verdict.outcome, Outcome::refuted) << verdict.reason;
    EXPECT_LE(verdict.p_value, run.alpha());
}

TEST(MeanIs, AllowsADeviationWithinEpsilon) {
    const MeanClaim claim{.reference = 0.501, .delta = 0.01, .epsilon = 0.002, .bounds = {0, 1}};
    EXPECT_EQ(mean_is(uniform, claim, run).outcome, Outcome::holds);
}

TEST(MeanIs, IsUndecidedAtTheEndOfItsBudget) {
    const Verdict verdict = mean_is(uniform, {.reference = 0.5, .delta = 0.001, .bounds = {0, 1}, .cap = 5000}, run);
    EXPECT_EQ(verdict.outcome, Outcome::undecided);
    EXPECT_EQ(verdict.samples, 5000u);
}

TEST(MeanIs, IsUndecidedUnderInfiniteVariance) {
    const auto inverse_root = [](RandomStream& random) { return 1 / std::sqrt(1 - random.uniform()); };
    const Verdict verdict = mean_is(inverse_root, {.reference = 2, .delta = 0.1, .cap = 100000}, run);
    EXPECT_EQ(verdict.outcome, Outcome::undecided);
    EXPECT_THAT(verdict.reason, HasSubstr("heavy tails"));
}

TEST(MeanIs, ZeroSampleVarianceDecidesNothing) {
    const auto one = [](RandomStream&) { return 1.0; };
    EXPECT_EQ(mean_is(one, {.reference = 1, .delta = 0.1, .cap = 10000}, run).outcome, Outcome::undecided);
    EXPECT_EQ(mean_is(one, {.reference = 2, .delta = 0.1, .cap = 10000}, run).outcome, Outcome::undecided);
}

TEST(MeanIs, ConstantValuesAreDecidedWithinBounds) {  // Hoeffding needs no variance
    const auto half = [](RandomStream&) { return 0.5; };
    EXPECT_EQ(mean_is(half, {.reference = 0.5, .delta = 0.1, .bounds = {0, 1}}, run).outcome, Outcome::holds);
    EXPECT_EQ(mean_is(half, {.reference = 0.8, .delta = 0.1, .bounds = {0, 1}}, run).outcome, Outcome::refuted);
}

TEST(MeanIs, DeclaredZeroVarianceChecksEveryValue) {
    const auto nearly = [](RandomStream& random) { return 1 + 1e-15 * random.uniform(); };
    EXPECT_EQ(mean_is(nearly, {.reference = 1, .epsilon = 1e-14, .zero_variance = true}, run).outcome, Outcome::holds);
    EXPECT_EQ(mean_is(nearly, {.reference = 1, .epsilon = 1e-17, .zero_variance = true}, run).outcome,
              Outcome::refuted);
}

TEST(MeanIs, NamesTheSampleThatIsNotFinite) {
    const auto sometimes = [](RandomStream& random) { return random.uniform() < 0.01 ? std::nan("") : 1.0; };
    const Verdict verdict = mean_is(sometimes, {.reference = 1, .delta = 0.1}, run);
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    EXPECT_THAT(verdict.reason, HasSubstr("is nan"));
}

TEST(MeanIs, RefutesFalseBounds) {
    const Verdict verdict = mean_is(uniform, {.reference = 0.5, .delta = 0.01, .bounds = {0, 0.9}}, run);
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    EXPECT_THAT(verdict.reason, HasSubstr("outside the declared bounds"));
}

TEST(MeanIs, RareSpikesWithinBoundsAreNotMissed) {
    const auto spike = [](RandomStream& random) { return random.uniform() < 1e-3 ? 1000.0 : 0.0; };
    EXPECT_EQ(mean_is(spike, {.reference = 1, .delta = 0.5, .bounds = {0, 1000}}, run).outcome, Outcome::holds);
    EXPECT_EQ(mean_is(spike, {.reference = 0, .delta = 0.5, .bounds = {0, 1000}}, run).outcome, Outcome::refuted);
}

TEST(MeanIs, OneSampleDecidesNothing) {
    EXPECT_EQ(mean_is(uniform, {.reference = 0.5, .delta = 0.1, .cap = 1}, run).outcome, Outcome::undecided);
    EXPECT_EQ(mean_is(uniform, {.reference = 0.9, .delta = 0.1, .bounds = {0, 1}, .cap = 1}, run).outcome,
              Outcome::undecided);
}

TEST(MeanIs, RefutesInfiniteValues) {
    const auto sometimes = [](RandomStream& random) { return 1 / std::floor(1000 * random.uniform()); };
    EXPECT_THAT(mean_is(sometimes, {.reference = 1, .delta = 0.1}, run).reason, HasSubstr("is inf"));
}

TEST(MeanIs, JudgesValuesOfAnySize) {  // squares under- and overflow from 1e-162 and 1e154 on
    for (const double unit : {5e-324 * 1e6, 1e-310, 1e-200, 1.0, 1e200, 1e300}) {
        const auto scaled = [unit](RandomStream& random) { return unit * random.uniform(); };
        for (const Interval& bounds : {Interval{0, unit}, Interval{}}) {
            const MeanClaim right{.reference = unit / 2, .delta = unit / 50, .bounds = bounds, .why_fewer = "uniform"};
            const MeanClaim wrong{
                .reference = 0.54 * unit, .delta = unit / 50, .bounds = bounds, .why_fewer = "uniform"};
            EXPECT_EQ(mean_is(scaled, right, run).outcome, Outcome::holds) << unit;
            EXPECT_EQ(mean_is(scaled, wrong, run).outcome, Outcome::refuted) << unit;
        }
    }
}

TEST(MeanIs, ForgetsWhatItBelievedBeforeItSawTheSpikes) {
    // One value in fifty is brighter by 4 to 8. Remembered maxima of early bets refuted 6 of 1000 of these.
    for (int i = 0; i < 300; ++i) {
        const plumb::Run one(static_cast<std::uint64_t>(i), "spikes", 1e-6);
        const auto spiking = [](RandomStream& random) {
            return random.uniform() + (random.uniform() < 0.02 ? 4 * (1 + random.uniform()) : 0);
        };
        const MeanClaim claim{.reference = 0.62,
                              .delta = 0.09,
                              .min_samples = 800,
                              .why_fewer = "one value in fifty spikes",
                              .cap = 1 << 17};
        EXPECT_NE(mean_is(spiking, claim, one).outcome, Outcome::refuted) << i;
    }
}

// The values are as of light that arrives by one ray in 250, less an estimate that hardly varies: before the first ray,
// each value is a sure win against it.
TEST(MeanIs, ForfeitsWhatItWonBeforeASpikeRuinedIt) {
    const auto rays = [](RandomStream& random) {
        return (random.uniform() < 0.004 ? 125 : 0) - 0.4 - 0.2 * random.uniform();
    };
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Verdict verdict =
            mean_is(rays, {.reference = 0, .delta = 0.05, .min_samples = 8192, .why_fewer = "one ray in 250 arrives"},
                    plumb::Run(seed, "rays", 1e-6));
        EXPECT_EQ(verdict.outcome, Outcome::holds) << seed << ": " << verdict.reason;
    }
}

// Exponential, and 1000 more once in 10,000: half of the runs of 6000 values have no spike.
TEST(MeanIs, IsNotRefutedBeforeItMetTheRare) {
    const auto rare = [](RandomStream& random) {
        return -std::log1p(-random.uniform()) + (random.uniform() < 1e-4 ? 1000 : 0);
    };
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        EXPECT_EQ(
            mean_is(rare, {.reference = 1.1, .delta = 0.05, .cap = 1 << 17}, plumb::Run(seed, "rare", 1e-6)).outcome,
            Outcome::undecided);
}

TEST(MeanIs, SaysWhatCouldHide) {
    const MeanClaim claim{.reference = 0.5, .delta = 0.02}, off{.reference = 0.6, .delta = 0.02};
    EXPECT_THAT(mean_is(uniform, claim, run).reason, HasSubstr("values rarer than 1 in 4,"));
    const Verdict refuted = mean_is(uniform, off, run);
    EXPECT_THAT(refuted.reason, HasSubstr("values rarer than 1 in 3"));
    EXPECT_GT(refuted.samples, 9 * least_draws_without_bounds);
    MeanClaim lowered = claim;
    lowered.why_fewer = "between 0 and 1";
    EXPECT_LT(mean_is(uniform, lowered, run).samples, 10'000u);
    lowered = claim;
    lowered.cap = 10'000;
    EXPECT_THAT(mean_is(uniform, lowered, run).reason, HasSubstr("nothing is decided before 65,536 samples"));
}

TEST(MeanIs, RefutesExactlyWithoutWaiting) {  // too bright, by a lower bound alone
    const MeanClaim claim{.reference = 0.4, .delta = 0.02, .bounds = {0, HUGE_VAL}};
    const Verdict verdict = mean_is(uniform, claim, run);
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    EXPECT_LT(verdict.samples, 10'000u);
}

TEST(MeanIs, SeesAStateAndFewSeeds) {
    double state = 0;
    std::mutex one_at_a_time;
    const auto walk = [&](RandomStream& random) {
        const std::scoped_lock lock(one_at_a_time);
        return state = 0.9 * state + random.uniform() - 0.5;
    };
    const Verdict verdict = mean_is(walk, {.reference = 0, .delta = 0.1}, run);
    EXPECT_EQ(verdict.outcome, Outcome::undecided);
    EXPECT_THAT(verdict.reason, HasSubstr("draws are not independent"));
    const auto ten_bits = [](RandomStream& random) { return RandomStream(random.below(1024)).uniform(); };
    const MeanClaim claim{.reference = 0.5, .delta = 0.005, .bounds = {0, 1}};
    EXPECT_THAT(mean_is(ten_bits, claim, run).reason, HasSubstr("1,024 different values"));
}

TEST(MeanIs, SurvivesCancellationOfTwelveDigits) {
    const auto far = [](RandomStream& random) { return 1e12 + random.uniform(); };
    EXPECT_EQ(mean_is(far, {.reference = 1e12 + 0.5, .delta = 0.02, .epsilon = 0.001}, run).outcome, Outcome::holds);
    EXPECT_EQ(mean_is(far, {.reference = 1e12 + 0.6, .delta = 0.02, .epsilon = 0.001}, run).outcome, Outcome::refuted);
}

TEST(MeanIs, RejectsSettingsThatMeanNothing) {
    EXPECT_THROW((void)mean_is(uniform, {.reference = 0.5}, run), std::logic_error);
    EXPECT_THROW((void)mean_is(uniform, {.reference = 0.5, .delta = 0.1, .epsilon = 0.2}, run), std::logic_error);
}

TEST(MeanAtMost, DecidesOneSide) {
    EXPECT_EQ(mean_at_most(uniform, {.bound = 0.6, .margin = 0.1, .bounds = {0, 1}}, run).outcome, Outcome::holds);
    EXPECT_EQ(mean_at_most(uniform, {.bound = 0.4, .margin = 0.1, .bounds = {0, 1}}, run).outcome, Outcome::refuted);
    const auto never = [](RandomStream&) { return 0.0; };
    EXPECT_EQ(mean_at_most(never, {.bound = 0.01, .margin = 0.01, .bounds = {0, 1}}, run).outcome, Outcome::holds);
}

}  // namespace
}  // namespace plumb
