#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <set>

#include "estimators/points/digital_net.h"
#include "estimators/points/sobol.h"
#include "estimators/points/zero_two.h"

namespace plumb {
namespace {

constexpr std::uint64_t quarter = std::uint64_t{1} << 62;

TEST(Sobol, FirstPointsInGrayCodeOrder) {
    // Each point is the last one xor a direction number, in binary: .1, .01, .001 on x; .1, .11, .101 on y.
    const std::vector<Point<2>> expected{{0, 0}, {0.5, 0.5}, {0.75, 0.25}, {0.25, 0.75}, {0.375, 0.375}};
    EXPECT_EQ(sobol_2d(5), expected);
}

TEST(ZeroTwo, FirstPointsByIndex) {
    const std::vector<Point<2>> expected{{0, 0}, {0.5, 0.5}, {0.25, 0.75}, {0.75, 0.25}, {0.125, 0.625}};
    EXPECT_EQ(zero_two(5), expected);
}

TEST(ZeroTwo, IsSobolByIndexAndTheSameSetAtPowersOfTwo) {
    // Two implementations of the same direction numbers: Boost's tables against Pascal's triangle.
    const auto gray = sobol_digits<2>(1 << 12), plain = zero_two_digits(1 << 12);
    for (std::size_t i = 0; i < gray.size(); ++i) ASSERT_EQ(gray[i], plain[i ^ (i >> 1)]) << i;
}

/// The number of leading binary digits that two fractions share.
int shared(std::uint64_t a, std::uint64_t b) {
    return std::countl_zero(a ^ b);
}

TEST(OwenScrambling, KeepsTheNumberOfSharedDigits) {
    RandomStream random(1);
    auto before = zero_two_digits(100);
    const auto after = owen_scrambled<2>(before, random);
    for (std::size_t i = 0; i < 100; ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (int axis = 0; axis < 2; ++axis)
                ASSERT_EQ(shared(before[i][axis], before[j][axis]), shared(after[i][axis], after[j][axis]));
}

TEST(OwenScrambling, EqualCoordinatesStayEqual) {
    RandomStream random(2);
    std::vector<std::uint64_t> coordinate{quarter, 7, quarter};
    owen_scramble(coordinate, random);
    EXPECT_EQ(coordinate[0], coordinate[2]);
    EXPECT_NE(coordinate[0], coordinate[1]);
}

TEST(OwenScrambling, ReachesEveryArrangementOfFourPoints) {
    // Three coins order the leading two digits of four points: eight arrangements, of which a digit shift reaches four.
    std::set<std::vector<std::uint64_t>> owen, shift;
    RandomStream random(3);
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<std::uint64_t> coordinate{0, quarter, 2 * quarter, 3 * quarter};
        std::vector<BinaryPoint<1>> points;
        for (const std::uint64_t x : coordinate) points.push_back({x});
        owen_scramble(coordinate, random);
        for (std::uint64_t& x : coordinate) x /= quarter;
        owen.insert(coordinate);
        std::vector<std::uint64_t> leading;
        for (const auto& point : digit_shifted<1>(points, random)) leading.push_back(point[0] / quarter);
        shift.insert(leading);
    }
    EXPECT_EQ(owen.size(), 8u);  // P(one missed) < 8 (7/8)^400 < 1e-22, and the seed is fixed
    EXPECT_EQ(shift.size(), 4u);
}

TEST(ToPoints, StaysBelowOne) {
    EXPECT_EQ(to_points<1>({{~std::uint64_t{0}}})[0][0], 1 - 0x1p-53);
}

}  // namespace
}  // namespace plumb
