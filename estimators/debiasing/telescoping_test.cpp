#include "estimators/debiasing/telescoping.h"

#include "analytic/enumeration.h"

namespace plumb {
namespace {

const std::vector<Rational> sequence{3, {1, 2}, 7, {22, 7}};
const auto difference = [](std::uint64_t k) { return Rational(sequence[k + 1] - sequence[k]); };

TEST(Telescoping, FiniteFormsReachTheLastTerm) {
    const FinitePmf<Rational> pmf({1, 2, 5});
    const auto single =
        enumerate([&](Choices& random) { return telescope_single_term(sequence[0], difference, pmf, random); });
    const auto sum =
        enumerate([&](Choices& random) { return telescope_roulette_sum(sequence[0], difference, pmf, random); });
    EXPECT_EQ(single.mean, sequence.back());
    EXPECT_EQ(sum.mean, sequence.back());
}

TEST(Telescoping, ForecastsAreTheEnumeratedVariances) {
    const FinitePmf<Rational> exact({1, 2, 5});
    const FinitePmf<double> pmf({1, 2, 5});
    const auto delta = [](std::uint64_t k) { return static_cast<double>(difference(k)); };
    const auto zero = [](std::uint64_t) { return 0.0; };
    const auto cost = [](std::uint64_t k) { return static_cast<double>(k + 1); };
    const auto single =
        enumerate([&](Choices& random) { return telescope_single_term(sequence[0], difference, exact, random); });
    const auto sum =
        enumerate([&](Choices& random) { return telescope_roulette_sum(sequence[0], difference, exact, random); });
    const auto forecast_single = forecast_single_term(delta, zero, cost, pmf, 3);
    const auto forecast_sum = forecast_roulette_sum(delta, zero, cost, pmf, 3);
    EXPECT_NEAR(forecast_single.variance, static_cast<double>(single.variance), 1e-12 * forecast_single.variance);
    EXPECT_NEAR(forecast_sum.variance, static_cast<double>(sum.variance), 1e-12 * forecast_sum.variance);
    EXPECT_NEAR(forecast_single.cost, (1 + 4 + 15) / 8.0, 1e-15);          // Σ (k+1) p_k
    EXPECT_NEAR(forecast_sum.cost, 1 + 2 * 7 / 8.0 + 3 * 5 / 8.0, 1e-15);  // Σ (k+1) P(K ≥ k)
}

template <class Pmf>
void expect_consistent(const Pmf& pmf) {
    EXPECT_DOUBLE_EQ(pmf.tail(0), 1);
    for (const std::uint64_t k : {0, 1, 2, 10}) EXPECT_NEAR(pmf.tail(k) - pmf.tail(k + 1), pmf.pmf(k), 1e-15) << k;
}

TEST(TelescopingPmf, IsTheDifferenceOfItsTail) {
    expect_consistent(Geometric(0.3));
    expect_consistent(PowerLaw(1.7));
    expect_consistent(truncated_zeta(2, 6));
    EXPECT_DOUBLE_EQ(truncated_zeta(1, 3).pmf(1), 3.0 / 11);  // 1, 1/2, 1/3 over 11/6
    EXPECT_EQ(truncated_zeta(1, 3).pmf(3), 0);
}

TEST(TelescopingPmf, SamplesTheirPmf) {
    // 100,000 draws: five standard deviations of a frequency are below 0.008.
    const auto frequency_of = [](const auto& pmf, std::uint64_t k) {
        RandomStream random(1);
        int hits = 0;
        for (int i = 0; i < 100000; ++i) hits += pmf.sample(random) == k;
        return hits / 1e5;
    };
    for (const std::uint64_t k : {0, 1, 2}) {
        EXPECT_NEAR(frequency_of(Geometric(0.3), k), Geometric(0.3).pmf(k), 0.008);
        EXPECT_NEAR(frequency_of(PowerLaw(1.7), k), PowerLaw(1.7).pmf(k), 0.008);
        EXPECT_NEAR(frequency_of(truncated_zeta(2, 3), k), truncated_zeta(2, 3).pmf(k), 0.008);
    }
}

TEST(TelescopingPmf, RefusesWhatIsNone) {
    EXPECT_THROW(Geometric(1), Error);
    EXPECT_THROW(Geometric(std::nan("")), Error);
    EXPECT_THROW(PowerLaw(0), Error);
    EXPECT_THROW(FinitePmf<double>({1, -1}), Error);
    EXPECT_THROW(FinitePmf<double>({}), Error);
    EXPECT_THROW(FinitePmf<double>({0, 0}), Error);
}

}  // namespace
}  // namespace plumb
