#include "core/integers.h"

#include <gmock/gmock.h>

namespace plumb {
namespace {

TEST(ParseIntegers, TakesExactlySoManyWithCommasBetween) {
    EXPECT_THAT(parse_integers("64,-48", 2), testing::ElementsAre(64, -48));
    EXPECT_THAT(parse_integers("7", 1), testing::ElementsAre(7));
    for (const char* bad : {"", "64", "64,", "64,48,", "64,48,1", "64, 48", "64,x", "64.5,1", "99999999999,1"})
        EXPECT_TRUE(parse_integers(bad, 2).empty()) << bad;
}

}  // namespace
}  // namespace plumb
