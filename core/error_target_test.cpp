#include "core/error_target.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

TEST(ErrorTarget, IsAbsoluteOrRelativeToTheValue) {
    EXPECT_TRUE((ErrorTarget{0.1, false}.met_by({.value = -100, .standard_error = 0.1})));
    EXPECT_FALSE((ErrorTarget{0.1, false}.met_by({.value = -100, .standard_error = 0.2})));
    EXPECT_TRUE((ErrorTarget{0.01, true}.met_by({.value = -100, .standard_error = 1})));
    EXPECT_FALSE((ErrorTarget{0.01, true}.met_by({.value = 0, .standard_error = 1e-300})));
    EXPECT_FALSE((ErrorTarget{1e300, false}.met_by({.value = 1}))) << "an unknown error meets no target";
}

TEST(ParseErrorTarget, IsAbsoluteOrRelative) {
    EXPECT_EQ(parse_error_target("1e-3").error, 1e-3);
    EXPECT_FALSE(parse_error_target("1e-3").relative);
    EXPECT_EQ(parse_error_target("2%").error, 0.02);
    EXPECT_TRUE(parse_error_target("2%").relative);
    EXPECT_EQ(parse_error_target("2 %").error, 0.02);
    for (const char* bad : {"", "%", "0", "-1", "nan", "inf", "1e-3x", "1%%", "1 % %", " 1"})
        EXPECT_THROW(parse_error_target(bad), Error) << bad;
}

}  // namespace
}  // namespace plumb
