#include "estimators/points/halton.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

TEST(RadicalInverse, MirrorsDigits) {
    EXPECT_EQ(radical_inverse(2, 0), 0);
    EXPECT_EQ(radical_inverse(2, 6), 3.0 / 8);    // 110 -> 0.011
    EXPECT_EQ(radical_inverse(3, 5), 7.0 / 9);    // 12 -> 0.21
    EXPECT_EQ(radical_inverse(5, 7), 11.0 / 25);  // 12 -> 0.21
    EXPECT_EQ(radical_inverse(2, 0xffffffff), 1 - 0x1p-32);
    EXPECT_LT(radical_inverse(3, 0xffffffff), 1);
}

TEST(Halton, FirstPoints) {
    const std::vector<Point<2>> expected{{0, 0}, {1.0 / 2, 1.0 / 3}, {1.0 / 4, 2.0 / 3}, {3.0 / 4, 1.0 / 9}};
    EXPECT_EQ(halton_2d(4), expected);
    EXPECT_EQ(halton_1d(3), (std::vector<Point<1>>{{0}, {0.5}, {0.25}}));
}

TEST(Hammersley, FirstPoints) {
    const std::vector<Point<2>> expected{{0, 0}, {1.0 / 3, 1.0 / 2}, {2.0 / 3, 1.0 / 4}};
    EXPECT_EQ(hammersley_2d(3), expected);
    EXPECT_EQ(hammersley_1d(2), (std::vector<Point<1>>{{0}, {0.5}}));
}

TEST(Halton, TooManyPointsAreRefusedBeforeMemoryIsTaken) {
    EXPECT_THROW(halton_2d(std::uint64_t{1} << 32), Error);
}

}  // namespace
}  // namespace plumb
