#include "analytic/piecewise_constant.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

TEST(PiecewiseConstant, DensityAndDistribution) {
    const PiecewiseConstant density({0, 0.25, 1}, {1, 3});
    EXPECT_EQ(density.pdf(0), 1);
    EXPECT_EQ(density.pdf(0.25), 1);
    const PiecewiseConstant steps = PiecewiseConstant::equal_pieces({1, 2, 1});
    EXPECT_DOUBLE_EQ(steps.pdf(0.5), 1.5);
    EXPECT_DOUBLE_EQ(steps.pdf(1), 0.75);
    EXPECT_DOUBLE_EQ(steps.cdf(0.5), 0.5);
    EXPECT_EQ(steps.cdf(0), 0);
    EXPECT_EQ(steps.cdf(1), 1);
}

TEST(PiecewiseConstant, InverseGoesRoundTrip) {
    const PiecewiseConstant density({0, 0.1, 0.15, 0.8, 1}, {0.4, 0.3, 0.2, 0.1});
    for (int i = 0; i <= 64; ++i) {
        const double u = i / 64.0;
        EXPECT_NEAR(density.cdf(density.inverse_cdf(u)), u, 1e-15);
    }
}

TEST(PiecewiseConstant, NamesBadInput) {
    EXPECT_THROW(PiecewiseConstant({0, 1}, {}), Error);
    EXPECT_THROW(PiecewiseConstant({0, 0.5, 0.5, 1}, {1, 1, 1}), Error);
    EXPECT_THROW(PiecewiseConstant({0, 0.5, 1}, {1, 0}), Error);
    EXPECT_THROW(PiecewiseConstant({0, 0.5, 1}, {1, std::nan("")}), Error);
    EXPECT_THROW(PiecewiseConstant({0.1, 1}, {1}), Error);
}

}  // namespace
}  // namespace plumb
