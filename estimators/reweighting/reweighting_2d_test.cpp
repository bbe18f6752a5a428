#include "estimators/reweighting/reweighting_2d.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "estimators/reweighting/reweighting_estimators_2d.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::vector<Point<2>> corners{{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}};
double x_plus_2y(const Point<2>& x) {
    return x[0] + 2 * x[1];
}

TEST(Reweighting2D, OfACentredGridIsTheMidpointRule) {
    EXPECT_NEAR(voronoi_estimate(x_plus_2y, corners).value, 1.5, 1e-15);
    EXPECT_NEAR(torus_estimate(x_plus_2y, corners).value, 1.5, 1e-15);
    EXPECT_NEAR(torus_tent_estimate(x_plus_2y, corners).value, 1.5, 1e-15);
    EXPECT_EQ(voronoi_estimate(x_plus_2y, corners).evaluations, 4u);
    EXPECT_EQ(voronoi_estimate(x_plus_2y, corners).standard_error, std::numeric_limits<double>::infinity());
}

TEST(Reweighting2D, DividesByGAndTheDensity) {
    const auto weights = reweighted_weights_2d(
        corners, [](const Point<2>& x) { return x[0]; }, [](const Point<2>&) { return 2.0; });
    EXPECT_THAT(weights, testing::Pointwise(testing::DoubleNear(1e-15), {0.5, 1.0 / 6, 0.5, 1.0 / 6}));
}

TEST(Reweighting2D, NamesTheSampleWhereTheDensityVanishes) {
    EXPECT_THAT(
        [] {
            reweighted_weights_2d(
                corners, [](const Point<2>&) { return 1.0; }, [](const Point<2>& x) { return x[0] < 0.5 ? 2.0 : 0.0; });
        },
        ThrowsMessage<Error>(HasSubstr("sample 1 at (0.75, 0.25): g p is 0")));
}

TEST(ReweightingEstimators2D, IntegrateConstantsExactlyWhereWeightsSumTo1) {
    for (const Estimator<2>& estimator : reweighting_estimators_2d()) {
        RandomStream random(3);
        const Estimate estimate = estimator.run([](const Point<2>&) { return 1.0; }, 32, random);
        EXPECT_EQ(estimate.evaluations, 32u) << estimator.id;
        EXPECT_NEAR(estimate.value, 1, estimator.id == "voronoi-reweighted" ? 0.5 : 1e-12) << estimator.id;
    }
}

}  // namespace
}  // namespace plumb
