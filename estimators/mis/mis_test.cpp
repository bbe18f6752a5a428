#include "estimators/mis/mis.h"

#include <boost/multiprecision/cpp_int.hpp>

#include "estimators/densities/density.h"
#include "estimators/mis/mis_estimators.h"

namespace plumb {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Doubles = std::vector<double>;
using Rationals = std::vector<Rational>;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class H>
Doubles weights(const H& heuristic, const Doubles& counts, const Doubles& pdfs) {
    return mis_weights<double>(heuristic, counts, pdfs);
}

TEST(MisWeights, HaveTheirDefinitions) {
    const Rationals n{1, 2, 3}, p{4, 1, {1, 3}};  // n p = 4, 2, 1
    EXPECT_EQ(mis_weights<Rational>(Balance{}, n, p), (Rationals{{4, 7}, {2, 7}, {1, 7}}));
    EXPECT_EQ(mis_weights<Rational>(Power{}, n, p), (Rationals{{16, 21}, {4, 21}, {1, 21}}));
    EXPECT_EQ(mis_weights<Rational>(Power{3}, n, p), (Rationals{{64, 73}, {8, 73}, {1, 73}}));
    EXPECT_EQ(mis_weights<Rational>(Maximum{}, n, p), (Rationals{1, 0, 0}));
    EXPECT_EQ(mis_weights<Rational>(Cutoff{0.5}, n, p), (Rationals{{2, 3}, {1, 3}, 0}));
    EXPECT_EQ(weights(Power{}, {1, 2, 3}, {4, 1, 1.0 / 3}), (Doubles{16.0 / 21, 4.0 / 21, 1.0 / 21}));
    EXPECT_EQ(weights(Maximum{}, {2, 1, 1}, {1, 2, 1}), (Doubles{0.5, 0.5, 0}));
}

TEST(MisWeights, SurviveTheCorners) {
    EXPECT_EQ(weights(Balance{}, {1, 1}, {1e300, 1e-300}), (Doubles{1, 0}));
    EXPECT_EQ(weights(Power{}, {1, 1}, {1e-300, 1e-300}), (Doubles{0.5, 0.5}));
    EXPECT_EQ(weights(Balance{}, {1e18, 1e18}, {1e300, 1e300}), (Doubles{0.5, 0.5}));
    EXPECT_EQ(weights(Power{50}, {1, 1}, {1e300, 5e-324}), (Doubles{1, 0}));
    EXPECT_EQ(weights(Power{2000}, {1, 1}, {1, 1}), (Doubles{0.5, 0.5}));
    EXPECT_EQ(weights(Balance{}, {1, 3}, {5e-324, 5e-324}), (Doubles{0.25, 0.75}));
}

TEST(MisWeights, GiveAllToDeltaTechniques) {
    EXPECT_EQ(weights(Balance{}, {1, 1}, {infinity, 1e300}), (Doubles{1, 0}));
    EXPECT_EQ(weights(Balance{}, {1, 3, 9}, {infinity, infinity, 7}), (Doubles{0.25, 0.75, 0}));
    EXPECT_EQ(weights(Balance{}, {0, 1}, {infinity, 2}), (Doubles{0, 1}));
}

TEST(MisWeights, AreZeroWhereNobodySamples) {
    EXPECT_EQ(weights(Balance{}, {1, 1}, {0, 0}), (Doubles{0, 0}));
    EXPECT_EQ(weights(Power{}, {0, 1}, {1, 0}), (Doubles{0, 0}));
    EXPECT_EQ(weights(Cutoff{0}, {1, 1}, {0, 2}), (Doubles{0, 1}));
}

TEST(MisWeights, RefuseInvalidInput) {
    EXPECT_THROW(weights(Balance{}, {1}, {1, 1}), Error);
    EXPECT_THROW(weights(Balance{}, {1, 1}, {1, std::nan("")}), Error);
    EXPECT_THROW(weights(Balance{}, {1, -1}, {1, 1}), Error);
    EXPECT_THROW(weights(Balance{}, {infinity, 1}, {1, 1}), Error);
    EXPECT_THROW(Power{0}, Error);
    EXPECT_THROW(Cutoff{1.5}, Error);
    EXPECT_THROW(mis_weights<Rational>(Power{1.5}, Rationals{1}, Rationals{1}), Error);
}

TEST(AccurateSum, KeepsWhatPlainSummationLoses) {
    Doubles values(1025, 0x1p-53);
    values[0] = 1;
    EXPECT_EQ(accurate_sum<double>(values), 1 + 1024 * 0x1p-53);
}

TEST(MisEstimators, AreExactForAMixtureOfTheirDensities) {
    // f = p_1 + p_2: with the balance heuristic and equal counts every contribution is the same.
    const std::vector<Technique<1>> techniques{technique_1d("linear", LinearDensity(1, 3)),
                                               technique_1d("peak", TruncatedExponential(5))};
    const Function<1> f = [&](const Point<1>& x) { return techniques[0].pdf(x) + techniques[1].pdf(x); };
    RandomStream random(1);
    const Estimate multi = mis_multi_sample<1>(f, techniques, std::vector<std::uint64_t>{3, 3}, Balance{}, random);
    EXPECT_NEAR(multi.value, 2, 1e-14);
    EXPECT_NEAR(multi.standard_error, 0, 1e-14);
    EXPECT_EQ(multi.evaluations, 6u);
    const Estimate one = mis_one_sample<1>(f, techniques, Doubles{5, 5}, Balance{}, 4, random);
    EXPECT_NEAR(one.value, 2, 1e-14);
    EXPECT_EQ(one.evaluations, 4u);
}

TEST(MisEstimators, DoNotKnowTheErrorOfOneSample) {
    const std::vector<Technique<1>> techniques{technique_1d("uniform", UniformDensity{})};
    RandomStream random(1);
    const Estimate estimate = mis_multi_sample<1>([](const Point<1>& x) { return x[0]; }, techniques,
                                                  std::vector<std::uint64_t>{1}, Balance{}, random);
    EXPECT_EQ(estimate.standard_error, infinity);
}

TEST(MisContribution, RefusesASampleThatItsTechniqueCannotMake) {
    EXPECT_THROW(mis_contribution<double>(1, 1.0, Balance{}, Doubles{1, 1}, Doubles{1, 0}), Error);
    EXPECT_THROW(mis_contribution<double>(1, 1.0, Balance{}, Doubles{1, 1}, Doubles{1, infinity}), Error);
}

}  // namespace
}  // namespace plumb
