#include "core/csv.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace plumb {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string complaint(std::string_view text) {
    try {
        parse_csv(text, "points.csv");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(CsvFields, AreTheTextBetweenCommas) {
    EXPECT_THAT(csv_fields("from, \"to\" ,,density\r"), ElementsAre("from", "to", "", "density"));
    EXPECT_THAT(csv_fields(""), ElementsAre(""));
}

TEST(CsvNumber, IsTheWholeField) {
    EXPECT_EQ(csv_number("-2e-3"), -2e-3);
    EXPECT_EQ(csv_number("inf"), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(csv_number("nan").has_value());
    for (const char* bad : {"", "1x", "x", "0x1p3", "1 2", "+-1", "1e999"}) EXPECT_FALSE(csv_number(bad)) << bad;
}

TEST(ParseCsv, ReadsRowsWithAndWithoutNames) {
    const NumberTable bare = parse_csv("0.5,1\n0.25,-2e-3\n", "points.csv");
    EXPECT_EQ(bare.columns, 2u);
    EXPECT_THAT(bare.values, ElementsAre(0.5, 1, 0.25, -2e-3));
    EXPECT_EQ(bare.line(1), 2u);
    const NumberTable named = parse_csv("x,f value\n0.5,1\n", "points.csv");
    EXPECT_THAT(named.header, ElementsAre("x", "f value"));
    EXPECT_EQ(named.line(0), 2u);
    EXPECT_EQ(named.where(0, 1), "points.csv:2: column 2 (f value)");
}

TEST(ParseCsv, AllowsWhatOtherProgramsWrite) {
    EXPECT_THAT(parse_csv("\xEF\xBB\xBF\"x\"\r\n \"0.5\"\r\n+1 \r\n\r\n", "f").values, ElementsAre(0.5, 1));
    EXPECT_THAT(parse_csv("1", "f").values, ElementsAre(1));
    EXPECT_THAT(parse_csv("5e-324\n0.99999999999999989\n", "f").values, ElementsAre(0x1p-1074, 1 - 0x1p-53));
}

TEST(ParseCsv, NamesLineAndColumnOfWhatIsNoNumber) {
    EXPECT_THAT(complaint("x,y\n0.5,1\n0.5,1x\n"), AllOf(HasSubstr("points.csv:3: column 2 (y)"), HasSubstr("'1x'")));
    EXPECT_THAT(complaint("0.5,1\n,1\n"), AllOf(HasSubstr(":2: column 1"), HasSubstr("nothing found")));
    for (const char* word : {"nan", "NaN", "inf", "-inf", "infinity", "1e999", "0x1p3", "1,5;2", "--1", "+-1", "1 2"})
        EXPECT_THAT(complaint(fmt::format("0.5\n{}\n", word)), HasSubstr("points.csv:2")) << word;
}

TEST(ParseCsv, DoesNotTakeABadFirstLineForNames) {
    EXPECT_THAT(complaint("nan\n0.5\n"), HasSubstr(":1: column 1"));
    EXPECT_THAT(complaint("0.5,abc\n0.5,1\n"), HasSubstr(":1: column 2"));
    EXPECT_THAT(complaint("a;b\n1\n"), "");  // one column of that name
}

TEST(ParseCsv, RefusesUnequalRowsAndEmptyFiles) {
    EXPECT_THAT(complaint("1,2\n3\n"), HasSubstr("points.csv:2: 1 columns found; line 1 has 2"));
    EXPECT_THAT(complaint("1\n\n2\n"), HasSubstr(":2: column 1: nothing found"));
    for (const char* text : {"", "\n\n", "x,y\n", "\xEF\xBB\xBF"})
        EXPECT_THAT(complaint(text), HasSubstr("no row of numbers")) << text;
    EXPECT_THAT(complaint(std::string_view("1\n\0\n", 4)), HasSubstr(":2"));
}

}  // namespace
}  // namespace plumb
