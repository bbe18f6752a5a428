#include "reports/text/text.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumb::reports {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Shortened, CountsCodePointsNotBytes) {
    EXPECT_EQ(columns_of("Σ|V|"), 4U);
    EXPECT_EQ(shortened("Σ|V|", 4), "Σ|V|");
    EXPECT_EQ(shortened("Σ|V| f", 4), "Σ|V…");
    EXPECT_EQ(shortened("abc", 1), "…");
    EXPECT_EQ(shortened("abc", 0), "");
}

TEST(Readable, Numbers) {
    EXPECT_EQ(readable(0.000123456), "0.000123");
    EXPECT_EQ(readable(infinity), "inf");
    EXPECT_EQ(readable(std::numeric_limits<double>::quiet_NaN()), "–");
    EXPECT_EQ(readable_count(0), "0");
    EXPECT_EQ(readable_count(9'999), "9999");
    EXPECT_EQ(readable_count(1'234'567), "1.23M");
    EXPECT_EQ(readable_count(999'999), "1M");
}

TEST(Readable, Intervals) {
    EXPECT_EQ(readable(Interval{-1e-5, 3e-5}), "1.0e-05 ± 2.0e-05");
    EXPECT_EQ(readable(Interval{0, 0}), "0");
    EXPECT_EQ(readable(Interval{0, 4.9}), "≤ 4.9");
    EXPECT_EQ(readable(Interval{-infinity, 0.5}), "≤ 0.5");
    EXPECT_EQ(readable(Interval{0.5, infinity}), "≥ 0.5");
    EXPECT_EQ(readable(Interval{}), "–");
}

TEST(Table, AlignsColumnsAndKeepsToTheWidth) {
    EXPECT_EQ(table({{"name"}, {"n", Align::right}, {"what"}},
                    {{"a", "10", "short"}, {"σσσσσ", "7", "quite a long text"}}, 24),
              "name    n  what\n"
              "a      10  short\n"
              "σσσσσ   7  quite a long…\n");
}

}  // namespace
}  // namespace plumb::reports
