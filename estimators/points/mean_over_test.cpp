#include "estimators/points/mean_over.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

const std::vector<Point<1>> three{{0.0}, {0.25}, {0.5}};
double twice(const Point<1>& x) {
    return 2 * x[0];
}

TEST(MeanOver, KnowsNoErrorOfADependentSet) {
    const Estimate estimate = mean_over<1>(three, twice);
    EXPECT_DOUBLE_EQ(estimate.value, 0.5);
    EXPECT_TRUE(std::isinf(estimate.standard_error));
    EXPECT_EQ(estimate.evaluations, 3u);
}

TEST(MeanOver, IndependentPointsGiveTheStandardError) {
    EXPECT_DOUBLE_EQ(mean_over_independent<1>(three, twice).standard_error, std::sqrt(0.25 / 3));
    EXPECT_TRUE(std::isinf(mean_over_independent<1>({{0.5}}, twice).standard_error));
}

TEST(MeanOver, AnInfiniteValueMakesTheMeanInfinite) {
    const auto inverse = [](const Point<1>& x) { return 1 / x[0]; };
    EXPECT_TRUE(std::isinf(mean_over<1>(three, inverse).value));
    EXPECT_TRUE(std::isinf(mean_over_independent<1>(three, inverse).standard_error));
}

TEST(MeanOver, NamesTheSampleThatIsNaN) {
    const auto root = [](const Point<1>& x) { return std::sqrt(0.3 - x[0]); };
    EXPECT_THAT([&] { (void)mean_over<1>(three, root); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("sample 2: f(0.5) is NaN")));
    EXPECT_THROW((void)mean_over<1>({}, twice), Error);
}

}  // namespace
}  // namespace plumb
