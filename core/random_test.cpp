#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumb {
namespace {

// Known answers of philox4x64-10, from the table that Random123 ships (tests/kat_vectors).
TEST(Philox, ReproducesItsPublishedVector) {
    RandomStream zero(0, 0, 0);
    EXPECT_EQ(zero.bits(), 0x16554d9eca36314cu);
    EXPECT_EQ(zero.bits(), 0xdb20fe9d672d0fdcu);
    EXPECT_EQ(zero.bits(), 0xd7e772cee186176bu);
    EXPECT_EQ(zero.bits(), 0x7e68b68aec7ba23bu);
}

TEST(RandomStream, IsAFunctionOfItsAddress) {
    RandomStream a(1, 2, 3), b(1, 2, 3);
    for (int k = 0; k < 9; ++k) EXPECT_EQ(a.bits(), b.bits());
}

TEST(RandomStream, NeighbouringAddressesDiffer) {
    const std::uint64_t base = RandomStream(1, 2, 3).bits();
    EXPECT_NE(base, RandomStream(2, 2, 3).bits());
    EXPECT_NE(base, RandomStream(1, 3, 3).bits());
    EXPECT_NE(base, RandomStream(1, 2, 4).bits());
}

TEST(RandomStream, UniformLiesInTheHalfOpenUnitInterval) {
    RandomStream random(7);
    for (int k = 0; k < 10000; ++k) {
        const double u = random.uniform();
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
    }
}

TEST(RandomStream, BelowReachesEveryValueAndNoOther) {
    RandomStream random(7);
    std::vector<int> seen(5);
    for (int k = 0; k < 1000; ++k) ++seen.at(random.below(5));
    EXPECT_TRUE(std::ranges::all_of(seen, [](int count) { return count > 0; }));
    EXPECT_EQ(random.below(1), 0u);
}

TEST(StreamId, IsFnv1a) {
    EXPECT_EQ(stream_id(""), 0xcbf29ce484222325u);
    EXPECT_EQ(stream_id("a"), 0xaf63dc4c8601ec8cu);
}

TEST(RandomPermutation, IsAPermutation) {
    RandomStream random(7);
    std::vector<std::uint32_t> order = random_permutation(100, random);
    EXPECT_FALSE(std::ranges::is_sorted(order));
    std::ranges::sort(order);
    for (std::uint32_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

}  // namespace
}  // namespace plumb
