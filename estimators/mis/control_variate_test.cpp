#include "estimators/mis/control_variate.h"

namespace plumb {
namespace {

const ControlVariate<1> identity{[](const Point<1>& x) { return x[0]; }, 0.5};

TEST(ControlVariate, OfALinearFunctionHasNoVariance) {
    const Function<1> f = [](const Point<1>& x) { return 3 * x[0] + 1; };
    RandomStream random(1);
    const Estimate known = control_variate<1>(f, identity, 3, 5, random);
    EXPECT_NEAR(known.value, 2.5, 1e-15);
    EXPECT_NEAR(known.standard_error, 0, 1e-15);
    const Estimate fitted = control_variate_fitted<1>(f, identity, 9, random);
    EXPECT_NEAR(fitted.value, 2.5, 1e-14);
    EXPECT_EQ(fitted.evaluations, 9u);
}

TEST(FittedCoefficient, IsTheLeastSquaresSlope) {
    const std::vector<Pair<double>> samples{{1, 0}, {2, 1}, {7, 2}, {100, 50}};
    EXPECT_DOUBLE_EQ(fitted_coefficient(samples, [](std::size_t i) { return i < 3; }), 3);  // (7 − 1)/2
    EXPECT_EQ(fitted_coefficient(samples, [](std::size_t i) { return i == 3; }), 0);
}

TEST(CrossFitting, UsesOtherFoldsOnly) {
    // Folds {0, 2} and {1, 3}: slopes 5 (from samples 1, 3) and 2 (from 0, 2).
    const std::vector<Pair<double>> samples{{1, 0}, {2, 1}, {3, 1}, {12, 3}};
    const std::vector<double> values = cross_fitted_values(samples, 1.0, 2);
    EXPECT_EQ(values, (std::vector<double>{1 - 5 * -1.0, 2, 3, 12 - 2 * 2.0}));
    EXPECT_THROW(cross_fitted_values(samples, 1.0, 1), Error);
}

TEST(CrossFitting, FallsBackToThePlainMeanForOneSample) {
    const std::vector<Pair<double>> one{{7, 3}};
    EXPECT_EQ(cross_fitted_values(one, 1.0, 4), std::vector<double>{7});
}

}  // namespace
}  // namespace plumb
