#include "estimators/replicates/replicates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "estimators/points/point_set_estimators.h"

namespace plumb {
namespace {

const Function<2> constant = [](const Point<2>&) { return 1.0; };

/// A run that returns 1, 2, 3, … in turn.
auto counting() {
    return [next = 0.0](const Function<2>&, std::uint64_t n, RandomStream&) mutable {
        return Estimate{.value = ++next, .evaluations = n};
    };
}

TEST(Replicated, MeanAndStandardErrorOfTheRuns) {
    RandomStream random(1);
    auto run = counting();
    const Estimate estimate = replicated<2>(std::ref(run), constant, 7, 4, random);  // 1 2 3 4: variance 5/3
    EXPECT_DOUBLE_EQ(estimate.value, 2.5);
    EXPECT_DOUBLE_EQ(estimate.standard_error, std::sqrt(5.0 / 3 / 4));
    EXPECT_EQ(estimate.evaluations, 28u);
}

TEST(Replicated, OneRunHasNoErrorBar) {
    RandomStream random(1);
    auto run = counting();
    EXPECT_TRUE(std::isinf(replicated<2>(std::ref(run), constant, 7, 1, random).standard_error));
    EXPECT_THROW((void)replicated<2>(std::ref(run), constant, 7, 0, random), Error);
}

TEST(Replicated, NoSpreadSaysNothing) {
    RandomStream random(1);
    for (const Estimator<2>& estimator : point_set_estimators_2d()) {
        if (estimator.unbiased) continue;
        const auto f = [](const Point<2>& x) { return x[0] * x[1]; };
        EXPECT_TRUE(std::isinf(replicated<2>(estimator.run, f, 16, 8, random).standard_error)) << estimator.id;
    }
}

TEST(Replicated, NaNIsAnError) {
    RandomStream random(1);
    const auto run = [](const Function<2>&, std::uint64_t, RandomStream&) { return Estimate{.value = std::nan("")}; };
    EXPECT_THROW((void)replicated<2>(run, constant, 7, 3, random), Error);
}

}  // namespace
}  // namespace plumb
