#include "estimators/densities/discrete.h"

namespace plumb {
namespace {

using Integers = std::vector<std::uint64_t>;

/// n Σw P(i), by adding up the table.
Integers mass_of(const AliasTable<std::uint64_t>& table) {
    Integers mass(table.columns().size());
    for (std::size_t i = 0; i < mass.size(); ++i) {
        mass[i] += table.columns()[i].threshold;
        mass[table.columns()[i].alias] += table.total() - table.columns()[i].threshold;
    }
    return mass;
}

TEST(AliasTable, HoldsIntegerWeightsExactly) {
    for (std::uint64_t code = 1; code < 4 * 4 * 4 * 4; ++code) {
        const Integers weights{code % 4, code / 4 % 4, code / 16 % 4, code / 64};
        const Integers mass = mass_of(AliasTable<std::uint64_t>(weights));
        for (std::size_t i = 0; i < 4; ++i) ASSERT_EQ(mass[i], 4 * weights[i]);
    }
}

TEST(AliasTable, HoldsRoundedWeightsAlmostExactly) {
    std::vector<double> weights;
    for (int i = 0; i < 1000; ++i) weights.push_back(1.0 / (1 + i % 37));
    const AliasTable<double> table(weights);
    std::vector<double> mass(weights.size());
    for (std::size_t i = 0; i < mass.size(); ++i) {
        mass[i] += table.columns()[i].threshold;
        mass[table.columns()[i].alias] += table.total() - table.columns()[i].threshold;
    }
    for (std::size_t i = 0; i < mass.size(); ++i) ASSERT_NEAR(mass[i] / 1000 / weights[i], 1, 1e-11);
}

TEST(DiscreteCdf, GivesEachWeightItsPositions) {
    const DiscreteCdf<std::uint64_t> cdf(Integers{0, 2, 0, 1, 0});
    EXPECT_EQ(cdf.total(), 3u);
    EXPECT_EQ(cdf.at(0), 1u);
    EXPECT_EQ(cdf.at(1), 1u);
    EXPECT_EQ(cdf.at(2), 3u);
    EXPECT_EQ(DiscreteCdf<double>(std::vector<double>{1, 2, 0}).at(3.0), 1u);  // rounded up to the total
}

TEST(Discrete, NeverDrawsAZeroWeight) {
    const Integers weights{0, 5, 0, 1};
    const DiscreteCdf<std::uint64_t> cdf(weights);
    const AliasTable<std::uint64_t> alias(weights);
    RandomStream random(1);
    for (int i = 0; i < 1000; ++i) {
        ASSERT_EQ(cdf.sample(random) % 2, 1u);
        ASSERT_EQ(alias.sample(random) % 2, 1u);
    }
}

TEST(Discrete, RefusesWhatIsNoDistribution) {
    EXPECT_THROW(DiscreteCdf<double>(std::vector<double>{}), Error);
    EXPECT_THROW(DiscreteCdf<double>(std::vector<double>{1, -1}), Error);
    EXPECT_THROW(DiscreteCdf<double>(std::vector<double>{1e308, 1e308}), Error);
    EXPECT_THROW(AliasTable<std::uint64_t>(Integers{0, 0}), Error);
    EXPECT_THROW(AliasTable<std::uint64_t>(Integers{1, ~std::uint64_t{0} / 2}), Error);  // times 2 columns
}

}  // namespace
}  // namespace plumb
