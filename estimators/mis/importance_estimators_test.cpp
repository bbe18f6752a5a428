#include "estimators/mis/importance_estimators.h"

namespace plumb {
namespace {

TEST(ImportanceEstimators, ComeNearTheIntegralAndCountEvaluations) {
    // ∫(x² + 1) = 4/3; each error bar is its own yardstick (6 of them: one in 10^9).
    const Function<1> f = [](const Point<1>& x) { return x[0] * x[0] + 1; };
    for (const Estimator<1>& estimator : importance_estimators_1d()) {
        std::uint64_t calls = 0;
        const Function<1> counted = [&](const Point<1>& x) { return ++calls, f(x); };
        RandomStream random(1);
        const Estimate estimate = estimator.run(counted, 1000, random);
        EXPECT_NEAR(estimate.value, 4.0 / 3, 6 * estimate.standard_error) << estimator.id;
        EXPECT_LT(estimate.standard_error, 0.1) << estimator.id;
        EXPECT_EQ(estimate.evaluations, calls) << estimator.id;
    }
}

TEST(ImportanceEstimators, WorkInTwoDimensionsAndWithOneSample) {
    const Function<2> f = [](const Point<2>& x) { return x[0] * x[1]; };
    for (const Estimator<2>& estimator : importance_estimators_2d()) {
        RandomStream random(1);
        const Estimate estimate = estimator.run(f, 1000, random);
        EXPECT_NEAR(estimate.value, 0.25, 6 * estimate.standard_error) << estimator.id;
        EXPECT_TRUE(std::isfinite(estimator.run(f, 1, random).value)) << estimator.id;
    }
}

}  // namespace
}  // namespace plumb
