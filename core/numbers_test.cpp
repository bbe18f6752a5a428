#include "core/numbers.h"

#include <gmock/gmock.h>

#include <limits>

namespace plumb {
namespace {

TEST(ParseIntegers, TakesExactlySoManyWithCommasBetween) {
    EXPECT_THAT(parse_integers("64,-48", 2), testing::ElementsAre(64, -48));
    EXPECT_THAT(parse_integers("7", 1), testing::ElementsAre(7));
    for (const char* bad : {"", "64", "64,", "64,48,", "64,48,1", "64, 48", "64,x", "64.5,1", "99999999999,1"})
        EXPECT_TRUE(parse_integers(bad, 2).empty()) << bad;
}

TEST(NumberOf, TakesTheWholeTextOrNothing) {
    EXPECT_EQ(number_of<double>("-1.5e3"), -1500);
    EXPECT_EQ(number_of<std::uint64_t>("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
    for (const char* bad : {"", " 1", "1 ", "+1", "1x", "0x1", "18446744073709551616", "-1", "1.5"})
        EXPECT_FALSE(number_of<std::uint64_t>(bad)) << bad;
}

TEST(WholeNumber, MayBeWrittenWithAnExponent) {
    EXPECT_EQ(whole_number("18446744073709551615"), ~std::uint64_t{0});
    EXPECT_EQ(whole_number("1e3"), 1000U);
    EXPECT_EQ(whole_number("2.5e6"), 2'500'000U);
    for (const char* bad : {"", "1.5", "1e-3", "-1", "1e30", "nan", "inf", "1e3 ", "x"})
        EXPECT_FALSE(whole_number(bad)) << bad;
}

}  // namespace
}  // namespace plumb
