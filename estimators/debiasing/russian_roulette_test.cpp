#include "estimators/debiasing/russian_roulette.h"

#include "analytic/enumeration.h"

namespace plumb {
namespace {

TEST(RussianRoulette, HasItsMeanAndVarianceExactly) {
    // A value of 1 or 5, each with probability 1/2: mean 3, variance 4.
    const Rational q(1, 3);
    const ExactMoments exact = enumerate([&](Choices& random) {
        return russian_roulette(
            q,
            [&] {
                return random.chance({1, 2}) ? Rational(1) : Rational(5);
            },
            random);
    });
    EXPECT_EQ(exact.mean, 3);
    EXPECT_EQ(exact.variance, roulette_variance<Rational>(3, 4, q));
}

TEST(RussianRoulette, EvaluatesOnSurvivalOnly) {
    RandomStream random(1);
    int calls = 0;
    for (int i = 0; i < 1000; ++i) {
        const int before = calls;
        const double value = russian_roulette(
            0.25, [&] { return ++calls, 2.0; }, random);
        ASSERT_EQ(value, calls > before ? 8.0 : 0.0);
    }
    EXPECT_EQ(russian_roulette(
                  1.0, [] { return 3.0; }, random),
              3);
}

TEST(RussianRoulette, RefusesAnImpossibleProbability) {
    RandomStream random(1);
    for (const double q : {0.0, -1.0, 1.5, std::nan("")})
        EXPECT_THROW(russian_roulette(
                         q, [] { return 1.0; }, random),
                     Error);
}

}  // namespace
}  // namespace plumb
