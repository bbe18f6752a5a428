#include "analytic/step_density.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

TEST(StepDensity, DensityAndDistribution) {
    const StepDensity density({0, 0.25, 1}, {1, 3});
    EXPECT_EQ(density.pdf(0), 1);
    EXPECT_EQ(density.pdf(0.25), 1);
    const StepDensity steps = StepDensity::equal_pieces({1, 2, 1});
    EXPECT_DOUBLE_EQ(steps.pdf(0.5), 1.5);
    EXPECT_DOUBLE_EQ(steps.pdf(1), 0.75);
    EXPECT_DOUBLE_EQ(steps.invert(0.5), 0.5);
    EXPECT_EQ(steps.invert(0), 0);
    EXPECT_EQ(steps.invert(1), 1);
}

TEST(StepDensity, InverseGoesRoundTrip) {
    const StepDensity density({0, 0.1, 0.15, 0.8, 1}, {0.4, 0.3, 0.2, 0.1});
    for (int i = 0; i <= 64; ++i) {
        const double u = i / 64.0;
        EXPECT_NEAR(density.invert(density.sample(u)), u, 1e-15);
    }
}

TEST(StepDensity, NamesBadInput) {
    EXPECT_THROW(StepDensity({0, 1}, {}), Error);
    EXPECT_THROW(StepDensity({0, 0.5, 0.5, 1}, {1, 1, 1}), Error);
    EXPECT_THROW(StepDensity({0, 0.5, 1}, {1, 0}), Error);
    EXPECT_THROW(StepDensity({0, 0.5, 1}, {1, std::nan("")}), Error);
    EXPECT_THROW(StepDensity({0.1, 1}, {1}), Error);
}

}  // namespace
}  // namespace plumb
