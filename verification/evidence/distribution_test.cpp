#include "verification/evidence/distribution.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>

namespace plumb {
namespace {

using testing::HasSubstr;

const Run run(2024, "distribution_test", 1e-6);

DistributionClaim equal_cells(std::size_t cells, double delta) {
    return {std::vector<double>(cells, 1 / static_cast<double>(cells)), delta};
}

TEST(DistributionIs, HoldsForTheRightDensity) {
    const auto draw = [](RandomStream& random) { return equal_cell(random.uniform(), 16); };
    EXPECT_EQ(distribution_is(draw, equal_cells(16, 0.05), run).outcome, Outcome::holds);
}

TEST(DistributionIs, RefutesADensityErrorOfTwoDelta) {
    // Half of the cells at 1.1/16, half at 0.9/16: phi = 0.1
    const auto draw = [](RandomStream& random) {
        const bool low = random.uniform() < 0.55;
        return equal_cell(0.5 * random.uniform() + (low ? 0 : 0.5), 16);
    };
    EXPECT_EQ(distribution_is(draw, equal_cells(16, 0.05), run).outcome, Outcome::refuted);
}

TEST(DistributionIs, AHitWhereTheDensityIsZeroRefutes) {
    const DistributionClaim claim{{0.5, 0.5, 0}, 0.5};
    const auto draw = [](RandomStream& random) { return random.uniform() < 0.01 ? 2u : random.below(2); };
    EXPECT_THAT(distribution_is(draw, claim, run).reason, HasSubstr("density is zero"));
    const auto outside = [](RandomStream& random) { return random.uniform() < 0.01 ? 17u : random.below(2); };
    EXPECT_EQ(distribution_is(outside, claim, run).outcome, Outcome::refuted);
}

TEST(DistributionIs, AOnePercentLeakFromTheLastCellIsSeen) {  // suites that drop a trailing pool miss it
    const DistributionClaim claim{{0.33, 0.33, 0.33, 0.01}, 0.05};
    const auto draw = [](RandomStream& random) { return random.below(3); };
    EXPECT_EQ(distribution_is(draw, claim, run).outcome, Outcome::refuted);
}

TEST(DistributionIs, ErrorsOfTheProbabilitiesAreAllowedFor) {
    const auto draw = [](RandomStream& random) { return random.uniform() < 0.51 ? 0u : 1u; };
    DistributionClaim claim{{0.5, 0.5}, 0.2};
    claim.errors = {0, 0};
    EXPECT_EQ(chi_square_verdict(std::vector<std::uint64_t>{51000, 49000}, claim, 1e-6, 0.01).outcome,
              Outcome::refuted);
    claim.errors = {0.01, 0.01};
    const Verdict allowed = chi_square_verdict(std::vector<std::uint64_t>{51000, 49000}, claim, 1e-6, 0.01);
    EXPECT_EQ(allowed.outcome, Outcome::holds);
    EXPECT_NEAR(allowed.statistic, 0, 1e-9);
    EXPECT_GT(allowed.deviation.high, 0.02);  // they add to what can hide
    EXPECT_EQ(distribution_is(draw, claim, run).outcome, Outcome::holds);
    EXPECT_EQ(chi_square_verdict(std::vector<std::uint64_t>{53000, 47000}, claim, 1e-6, 0.01).outcome,
              Outcome::refuted);
    claim.errors = {0.01};
    EXPECT_THROW((void)distribution_is(draw, claim, run), std::logic_error);
}

TEST(DistributionIs, MissingMassIsAMistakeOfTheClaim) {
    const auto draw = [](RandomStream& random) { return random.below(2); };
    EXPECT_THROW((void)distribution_is(draw, {{0.5, 0.4}, 0.1}, run), std::logic_error);
}

TEST(DistributionIs, ACellTooRareIsAnError) {
    const auto draw = [](RandomStream& random) { return random.below(2); };
    EXPECT_THROW((void)distribution_is(draw, {{0.5, 0.5 - 1e-12, 1e-12}, 0.1}, run), Error);
}

TEST(DistributionIs, AWalkIsNoSampler) {
    const auto walk = [cell = std::make_shared<std::atomic<std::size_t>>(0)](RandomStream& random) {
        return *cell = (*cell + random.below(2)) % 16;
    };
    const Verdict verdict = distribution_is(walk, equal_cells(16, 0.05), run);
    EXPECT_EQ(verdict.outcome, Outcome::undecided);
    EXPECT_THAT(verdict.reason, HasSubstr("draws are not independent"));
}

TEST(ChiSquareVerdict, MoreEvenThanChanceIsUndecided) {
    const std::vector<std::uint64_t> even(64, 850), by_chance{1000, 1000};
    EXPECT_THAT(chi_square_verdict(even, equal_cells(64, 0.05), 1e-6, 0.01).reason, HasSubstr("more even than chance"));
    EXPECT_EQ(chi_square_verdict(by_chance, equal_cells(2, 0.3), 1e-6, 0.01).outcome, Outcome::holds);
}

TEST(DistributionSamples, GrowWithTheLevelAndWithRareCells) {
    const DistributionClaim claim{{0.001, 0.999}, 0.5};
    EXPECT_EQ(distribution_samples(claim, 0.01, 0.01), 100000u);  // expected counts of 100
    EXPECT_NEAR(static_cast<double>(distribution_samples(claim, 1e-4, 0.01)), 1000 * std::pow(3.8905918864, 6) / 16, 1);
}

TEST(EqualCell, PutsWhatIsOutsideBeyondTheLastCell) {
    EXPECT_EQ(equal_cell(0, 4), 0u);
    EXPECT_EQ(equal_cell(std::nextafter(1.0, 0.0), 4), 3u);
    EXPECT_EQ(equal_cell(1, 4), 4u);
    EXPECT_EQ(equal_cell(-0.1, 4), 4u);
    EXPECT_EQ(equal_cell(std::nan(""), 4), 4u);
}

}  // namespace
}  // namespace plumb
