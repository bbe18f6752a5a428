#include "verification/evidence/rate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace {

const Run run(2024, "rate_test", 1e-6);

// An estimate whose error is (u − 1/2)·n^-1: the MSE is n^-2/12.
Estimate linear_error(std::uint64_t n, RandomStream& random) {
    return {(random.uniform() - 0.5) / static_cast<double>(n), 0, n};
}

ConvergenceSetting setting() {
    return {.estimator = "toy", .integrand = "zero", .truth = 0, .n = {16, 32, 64, 128}, .replicates = 1000};
}

TEST(RateIs, HoldsForTheRightExponent) {
    const Verdict verdict = rate_is(linear_error, setting(), {-2.1, -1.9}, run);
    EXPECT_EQ(verdict.outcome, Outcome::holds) << verdict.reason;
}

TEST(RateIs, RefutesAnotherExponent) {
    EXPECT_EQ(rate_is(linear_error, setting(), {-3.1, -2.5}, run).outcome, Outcome::refuted);
}

TEST(RateIs, IsUndecidedWhenTheSlopeIsTooUncertain) {
    EXPECT_EQ(rate_is(linear_error, setting(), {-2.001, -1.999}, run).outcome, Outcome::undecided);
}

TEST(RateIs, IsUndecidedAtZeroError) {
    const auto exact = [](std::uint64_t n, RandomStream&) { return Estimate{0, 0, n}; };
    EXPECT_EQ(rate_is(exact, setting(), {-3, -1}, run).outcome, Outcome::undecided);
}

TEST(RateIs, RefutesValuesThatAreNotNumbers) {
    const auto nan = [](std::uint64_t n, RandomStream& random) {
        return Estimate{n == 64 && random.uniform() < 0.01 ? std::nan("") : random.uniform(), 0, n};
    };
    const Verdict verdict = rate_is(nan, setting(), {-3, -1}, run);
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    EXPECT_EQ(verdict.reason, "the MSE at n = 64 is nan");
}

// n^-2 until 64, then no more: n^-1.3 in all.
TEST(RateIs, RefutesWhatIsNoPowerLaw) {
    const auto stalled = [](std::uint64_t n, RandomStream& random) {
        return linear_error(std::min<std::uint64_t>(n, 64), random);
    };
    const Verdict verdict = rate_is(stalled, setting(), {-1.7, -1.4}, run);
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    EXPECT_THAT(verdict.reason, testing::HasSubstr("no power law"));
}

TEST(RateIs, OneReplicateDecidesNothing) {
    ConvergenceSetting single = setting();
    single.replicates = 1;
    EXPECT_EQ(rate_is(linear_error, single, {-3, -1}, run).outcome, Outcome::undecided);
}

TEST(MeasureConvergence, RecordsErrorBiasAndEvaluations) {
    const Series series = measure_convergence(linear_error, setting(), run);
    ASSERT_EQ(series.points.size(), 4u);
    const ConvergencePoint& first = series.points.front();
    EXPECT_EQ(first.evaluations, 16);
    EXPECT_TRUE(first.mse_interval.contains(1 / (12.0 * 16 * 16)));
    EXPECT_LT(std::abs(first.bias), 6 * first.bias_standard_error);
}

TEST(FitSlope, SaysWhatIsNoPowerLaw) {
    const auto bent = [](std::uint64_t n, RandomStream& random) {
        return linear_error(std::min<std::uint64_t>(n, 32), random);
    };
    EXPECT_EQ(measure_convergence(linear_error, setting(), run).slope.doubt, "");
    EXPECT_THAT(measure_convergence(bent, setting(), run).slope.doubt, testing::HasSubstr("no power law"));
}

TEST(FitSlope, HasNoIntervalWhereTailsLeaveNone) {
    const auto spikes = [](std::uint64_t n, RandomStream& random) {
        return Estimate{random.uniform() < 1e-2 ? 1 / static_cast<double>(n) : 1e-6, 0, n};
    };
    ConvergenceSetting few = setting();
    few.replicates = 100;
    const Slope slope = measure_convergence(spikes, few, run).slope;
    EXPECT_FALSE(slope.interval.bounded());
    EXPECT_THAT(slope.doubt, testing::HasSubstr("undecided"));
}

TEST(FitSlope, IsExactOnAPowerLaw) {
    std::vector<ConvergencePoint> points;
    for (const std::uint64_t n : {10u, 100u, 1000u}) {
        ConvergencePoint& p = points.emplace_back();
        p.n = n;
        p.mse = 7 * std::pow(static_cast<double>(n), -1.5);
        p.log_mse_error = 0.1;
    }
    EXPECT_NEAR(fit_slope(points, 0.95).value, -1.5, 1e-12);
    for (ConvergencePoint& p : points) p.log_mse_error = 0;  // a deterministic method
    EXPECT_NEAR(fit_slope(points, 0.95).value, -1.5, 1e-12);
    EXPECT_FALSE(fit_slope(points, 0.95).interval.bounded());
    points.resize(1);
    EXPECT_TRUE(std::isnan(fit_slope(points, 0.95).value));
}

}  // namespace
}  // namespace plumb
