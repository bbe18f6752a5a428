#include "core/moments.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumb {
namespace {

Moments moments_of(const std::vector<double>& values) {
    Moments m;
    for (const double x : values) m.add(x);
    return m;
}

TEST(Moments, OfAKnownSet) {
    const Moments m = moments_of({1, 2, 3, 4, 10});  // mean 4, central sums 50, 180, 1394
    EXPECT_DOUBLE_EQ(m.mean(), 4);
    EXPECT_DOUBLE_EQ(m.variance(), 12.5);
    EXPECT_DOUBLE_EQ(m.skewness(), std::sqrt(5.0) * 180 / std::pow(50.0, 1.5));
    EXPECT_DOUBLE_EQ(m.kurtosis(), 5.0 * 1394 / 2500);
}

TEST(Moments, MergeEqualsAddingAll) {
    Moments left = moments_of({0.5, -3, 7});
    left.merge(moments_of({2, 2.25, 100, -8}));
    const Moments all = moments_of({0.5, -3, 7, 2, 2.25, 100, -8});
    EXPECT_EQ(left.count(), all.count());
    EXPECT_NEAR(left.mean(), all.mean(), 1e-13);
    EXPECT_NEAR(left.variance(), all.variance(), 1e-10);
    EXPECT_NEAR(left.skewness(), all.skewness(), 1e-13);
    EXPECT_NEAR(left.kurtosis(), all.kurtosis(), 1e-13);
}

TEST(Moments, OfABlockEqualsAddingAll) {
    std::vector<double> values, near_zero;  // the same but for an exact offset, whose moments are known better
    for (int i = 0; i < 43; ++i) {
        near_zero.push_back(i * i % 17 - 0.25 * i);
        values.push_back(1e6 + near_zero.back());
    }
    const Moments block = Moments::of(values), all = moments_of(near_zero);
    EXPECT_EQ(block.count(), all.count());
    EXPECT_NEAR(block.mean() - 1e6, all.mean(), 1e-9);
    EXPECT_NEAR(block.variance() / all.variance(), 1, 1e-12);
    EXPECT_NEAR(block.skewness(), all.skewness(), 1e-9);
    EXPECT_NEAR(block.kurtosis(), all.kurtosis(), 1e-9);
    EXPECT_EQ(Moments::of({}).count(), 0u);
    EXPECT_TRUE(std::isinf(Moments::of(std::vector{3.0}).variance()));
}

TEST(Moments, UnknownIsInfiniteNotZero) {
    EXPECT_TRUE(std::isnan(Moments().mean()));
    EXPECT_TRUE(std::isinf(moments_of({3}).variance()));
    EXPECT_TRUE(std::isinf(moments_of({3}).standard_error()));
}

TEST(Moments, SurviveALargeOffset) {
    const double offset = 1e12;
    const Moments m = moments_of({offset + 1, offset + 2, offset + 3});
    EXPECT_DOUBLE_EQ(m.variance(), 1);
}

}  // namespace
}  // namespace plumb
