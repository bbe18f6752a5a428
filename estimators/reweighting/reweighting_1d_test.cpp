#include "estimators/reweighting/reweighting_1d.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "estimators/densities/density.h"
#include "estimators/replicates/batches.h"
#include "estimators/reweighting/cells_1d.h"
#include "estimators/reweighting/control_variate_line.h"
#include "estimators/reweighting/piecewise_strata.h"
#include "estimators/reweighting/reweighting_estimators_1d.h"
#include "estimators/reweighting/reweighting_slopes_1d.h"
#include "estimators/reweighting/samples_1d.h"
#include "estimators/reweighting/tent.h"
#include "estimators/reweighting/warp.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using Samples = std::vector<double>;

double dot(const Samples& weights, const Samples& values) {
    return std::inner_product(weights.begin(), weights.end(), values.begin(), 0.0);
}

TEST(Reweighting, OneSampleIsPlainMonteCarlo) {
    EXPECT_THAT(reweighted_weights_1d(Samples{0.3}), ElementsAre(1));
    EXPECT_THAT(stratified_reweighted_weights_1d(Samples{0.3}), ElementsAre(1));
}

TEST(Reweighting, DividesTheCellByItsExpectation) {
    // g_2(x) = (1 + 6x − 6x²)/2: g_2(1/4) = 17/16; cells of {1/4, 1/2}: 3/8, 5/8
    EXPECT_THAT(reweighted_weights_1d(Samples{0.25, 0.5}), ElementsAre(0.375 * 16 / 17, 0.5));
    EXPECT_THAT(stratified_reweighted_weights_1d(Samples{0.25, 0.5}), ElementsAre(0.375, 0.5));
}

TEST(Reweighting, TrapezoidIsExactForLines) {
    const Samples samples{0.9, 0.2, 0.55};
    EXPECT_DOUBLE_EQ(dot(trapezoid_weights_1d(samples), {0.9, 0.2, 0.55, 0, 1}), 0.5);
}

TEST(Tent, FoldsExactly) {
    EXPECT_EQ(tent(0.0), 0);
    EXPECT_EQ(tent(0.5), 1);
    EXPECT_EQ(tent(1.0), 0);
    EXPECT_EQ(tent(0x1p-1074), 0x1p-1073);
    EXPECT_EQ(tent(1 - 0x1p-53), 0x1p-52);
    EXPECT_EQ((tent(Point<2>{0.25, 0.75})), (Point<2>{0.5, 0.5}));
}

TEST(ControlVariateLine, IsExactForLinesAndCountsItsEvaluations) {
    const Estimate estimate =
        control_variate_estimate_1d([](const Point<1>& x) { return 3 - 2 * x[0]; }, Samples{0.1, 0.7});
    EXPECT_DOUBLE_EQ(estimate.value, 2);
    EXPECT_EQ(estimate.evaluations, 4u);
    EXPECT_THROW((void)endpoint_line([](const Point<1>& x) { return 1 / x[0]; }), Error);
}

TEST(Warp, WhatIsProportionalToTheDensityBecomesConstant) {
    const LinearDensity density(0.5, 1.5);
    const auto f = warped([&](const Point<1>& x) { return 3 * density.pdf(x[0]); }, density);
    for (const double u : {0.0, 0.37, 1.0}) EXPECT_DOUBLE_EQ(f({u}), 3);
    const auto one = warped([](const Point<1>&) { return 1.0; }, density);
    EXPECT_DOUBLE_EQ(one({0.0}), 2);  // p(0) = 1/2
}

TEST(PiecewiseStrata, CountsFollowTheMasses) {
    const auto steps = StepDensity::equal_pieces({1, 2, 3, 4});
    EXPECT_THAT(stratum_counts(steps, 10), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(stratum_counts(steps, 20), ElementsAre(2, 4, 6, 8));
    EXPECT_THAT(stratum_counts(steps, 2), ElementsAre(1, 1, 1, 1));
    RandomStream random(1);
    const auto one = [](const Point<1>&) { return 1.0; };
    EXPECT_DOUBLE_EQ(piecewise_strata_estimate(one, steps, std::vector<std::uint64_t>{1, 1, 1, 1}, random).value, 1);
    EXPECT_THROW((void)piecewise_strata_estimate(one, steps, std::vector<std::uint64_t>{1, 0, 1, 1}, random), Error);
    EXPECT_THROW((void)piecewise_strata_estimate(one, steps, std::vector<std::uint64_t>{1, 1}, random), Error);
}

TEST(Batches, ShareTheSamplesAndKnowTheirError) {
    RandomStream random(1);
    std::vector<std::uint64_t> sizes;
    const Estimate mean = mean_of_batches(
        [&](std::uint64_t n, RandomStream&) {
            sizes.push_back(n);
            return Estimate{.value = static_cast<double>(sizes.size()), .evaluations = n};
        },
        10, 4, random);
    EXPECT_THAT(sizes, ElementsAre(3, 3, 2, 2));
    EXPECT_EQ(mean.value, 2.5);
    EXPECT_EQ(mean.evaluations, 10u);
    EXPECT_DOUBLE_EQ(mean.standard_error, std::sqrt(5.0 / 3 / 4));
    EXPECT_THROW((void)mean_of_batches({}, 3, 4, random), Error);
}

TEST(ReweightingEstimators, IntegrateAConstantOrThereabouts) {
    for (const Estimator<1>& estimator : reweighting_estimators_1d()) {
        RandomStream random(3, stream_id(estimator.id));
        const Estimate estimate = estimator.run([](const Point<1>&) { return 1.0; }, 4096, random);
        EXPECT_NEAR(estimate.value, 1, 0.02) << estimator.id;
        EXPECT_NEAR(static_cast<double>(estimate.evaluations), 4096, 2) << estimator.id;
    }
}

TEST(ReweightingSlopes, FollowSmoothnessAndEndValues) {
    const Interval two{-2.25, -1.75}, four{-4.25, -3.75};
    Integrand<1> f;
    f.value = [](const Point<1>& x) { return x[0]; };
    f.integral = "0.5";
    f.variance = "0.0833";
    f.smoothness = Smoothness::kink;
    f.periodic_smoothness = Smoothness::jump;
    EXPECT_EQ(torus_slope_1d(f), two);
    EXPECT_EQ(tent_slope_1d(f), four);
    EXPECT_EQ(clipped_slope_1d(f), four);
    EXPECT_EQ(divided_slope_1d(f), two);
    f.value = [](const Point<1>& x) { return std::abs(tent(x[0])); };
    EXPECT_EQ(divided_slope_1d(f), four);
    EXPECT_EQ(stepped_density_slope_1d(f), two);
    f.variance = "0";
    EXPECT_EQ(torus_slope_1d(f), std::nullopt);
    f.smoothness = Smoothness::singular;
    EXPECT_EQ(divided_slope_1d(f), std::nullopt);
}

}  // namespace
}  // namespace plumb
