#include "scenes/film/wide_sum.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/random.h"

namespace plumb {
namespace {

double sum_of(std::initializer_list<double> terms) {
    WideSum sum;
    for (const double x : terms) sum.add(x);
    return sum.value();
}

TEST(WideSum, KeepsWhatDoublesLose) {
    EXPECT_EQ(sum_of({}), 0);
    EXPECT_EQ(sum_of({1e300, 1, -1e300}), 1);
    EXPECT_EQ(sum_of({-1e300, -0x1p-64, 1e300}), -0x1p-64);
    EXPECT_EQ(sum_of({-3.5}), -3.5);
    EXPECT_EQ(sum_of({0x1p-70, 0x1p-70}), 0);  // each rounds to a multiple of 2^-64
    const double most = std::numeric_limits<double>::max();
    EXPECT_EQ(sum_of({most, most, -most}), most);
    EXPECT_EQ(sum_of({most, most}), HUGE_VAL);
    EXPECT_EQ(sum_of({-most, -most}), -HUGE_VAL);
}

TEST(WideSum, RoundsOnceToNearestEven) {
    EXPECT_EQ(sum_of({0x1p60, 0x1p7}), 0x1p60);                   // a tie: to even
    EXPECT_EQ(sum_of({0x1p60, 0x1p7, 0x1p-64}), 0x1p60 + 0x1p8);  // a little above it
    EXPECT_EQ(sum_of({0x1p60 + 0x1p8, 0x1p7}), 0x1p60 + 0x1p9);   // the other even
    EXPECT_EQ(sum_of({0x1p200, 0x1p147, 0x1p-60}), 0x1p200 + 0x1p148);
}

TEST(WideSum, SumsIntegersExactly) {
    __extension__ using Integer = __int128;
    RandomStream random(5);
    for (int set = 0; set < 100; ++set) {
        WideSum sum, part;
        ExactSum small;
        Integer exact = 0;
        for (int i = 0; i < 50; ++i) {
            const auto integer = static_cast<std::int64_t>(random.bits()) >> (11 + random.below(40));
            const auto shift = static_cast<int>(random.below(60));
            const double term = std::ldexp(static_cast<double>(integer), shift);
            if (ExactSum::accepts(term))
                small.add(term);
            else
                (i % 2 == 0 ? sum : part).add(term);
            exact += static_cast<Integer>(integer) << shift;
        }
        sum.merge(part);
        sum.add(small);
        EXPECT_EQ(sum.value(), static_cast<double>(exact));
    }
}

TEST(WideSum, TakesInExactSumsOfAnyScale) {
    ExactSumOfSquares squares;
    squares.add(0.25);
    squares.add(0x1p60);
    WideSum sum;
    sum.add(-0x1p60);
    sum.add(squares);
    EXPECT_EQ(sum.value(), 0.25);
    ExactSum negative;
    negative.add(-0.75);
    sum.add(negative);
    EXPECT_EQ(sum.value(), -0.5);
}

TEST(WideSum, IsInfiniteWithInfiniteTerms) {
    EXPECT_EQ(sum_of({1, HUGE_VAL}), HUGE_VAL);
    EXPECT_TRUE(std::isnan(sum_of({HUGE_VAL, -HUGE_VAL})));
}

TEST(ExactSumOfSquares, RoundsEachTermOnceToAMultipleOfItsResolution) {
    RandomStream random(1, 2);
    for (int exponent = -160; exponent <= 99; ++exponent)
        for (const double sign : {1.0, -1.0}) {
            const double x = sign * std::ldexp(0.5 + random.uniform() / 2, exponent);
            ASSERT_TRUE(ExactSumOfSquares::accepts(x)) << x;
            ExactSumOfSquares sum;
            sum.add(x);
            EXPECT_EQ(sum.value(), std::ldexp(std::nearbyint(std::ldexp(x, 128)), -128)) << x;
        }
    EXPECT_FALSE(ExactSumOfSquares::accepts(0x1p101));
}

TEST(ExactSumOfSquares, KeepsWhatIsSmallBesideWhatIsLarge) {
    ExactSumOfSquares sum;
    sum.add(0x1p99);
    sum.add(0x1p-128);
    sum.add(-0x1p99);
    EXPECT_EQ(sum.value(), 0x1p-128);
}

}  // namespace
}  // namespace plumb
