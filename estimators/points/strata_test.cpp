#include "estimators/points/strata.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace {

constexpr double largest_below_one = 1 - 0x1p-53;

TEST(Strata, TheLargestFractionStaysInItsStratum) {
    for (const std::uint64_t n : {1ull, 3ull, 49ull, 1000ull, 999983ull, 1ull << 40})
        for (const std::uint64_t i : {std::uint64_t{0}, n / 3, n / 2, n - 1})
            for (const double u : {0.0, 0.5, largest_below_one}) {
                const double x = in_stratum(i, n, u);
                EXPECT_GE(x, stratum_edge(i, n));
                EXPECT_LT(x, stratum_edge(i + 1, n));
                EXPECT_LT(x, 1);
                EXPECT_EQ(stratum_of(x, n), i);
            }
}

TEST(Strata, LookUpAtEveryEdge) {
    for (std::uint64_t n = 1; n < 500; ++n)
        for (std::uint64_t i = 0; i < n; ++i) {
            ASSERT_EQ(stratum_of(stratum_edge(i, n), n), i) << n;
            ASSERT_EQ(stratum_of(std::nextafter(stratum_edge(i + 1, n), 0), n), i) << n;
        }
}

TEST(Grid, DivisorsNearestEachOther) {
    EXPECT_EQ(grid_of(1), (Grid{1, 1}));
    EXPECT_EQ(grid_of(16), (Grid{4, 4}));
    EXPECT_EQ(grid_of(32), (Grid{8, 4}));
    EXPECT_EQ(grid_of(12), (Grid{4, 3}));
    EXPECT_EQ(grid_of(13), (Grid{13, 1}));
}

}  // namespace
}  // namespace plumb
