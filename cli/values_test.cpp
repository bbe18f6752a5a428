#include "cli/values.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb::cli {
namespace {

TEST(ParseDuration, KnowsItsUnits) {
    EXPECT_EQ(parse_duration("90").count(), 90);
    EXPECT_EQ(parse_duration("1.5m").count(), 90);
    EXPECT_EQ(parse_duration("1h").count(), 3600);
    EXPECT_THROW(parse_duration("-1s"), Error);
    EXPECT_THROW(parse_duration("1d"), Error);
    EXPECT_THROW(parse_duration("nan"), Error);
}

TEST(ParseStrategy, CountsVerticesFromBothEnds) {
    EXPECT_EQ(parse_strategy("0,2"), (std::vector<int>{0, 2}));
    EXPECT_EQ(parse_strategy("3,1"), (std::vector<int>{3, 1}));
    for (const char* bad : {"", "2", "-1,3", "2,0", "0,1", "1,1,1", "1,", "a,b", "1, 2"})
        EXPECT_THROW(parse_strategy(bad), Error) << bad;
}

TEST(ParseDomain, HasBothEndsOfEachAxis) {
    EXPECT_EQ(parse_domain("0,1"), (std::vector<double>{0, 1}));
    EXPECT_EQ(parse_domain("-1,1.5,1e-3,2"), (std::vector<double>{-1, 1.5, 1e-3, 2}));
    for (const char* bad : {"", "0", "0,1,", ",0,1", "1,0", "0,0", "0,1,2", "0,1,0,nan", "0,inf", "0;1", "0,1,0,1,0,1",
                            "-1.7e308,1.7e308"})
        EXPECT_THROW(parse_domain(bad), Error) << bad;
}

}  // namespace
}  // namespace plumb::cli
