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

TEST(ParseCsv, ReadsEverySeparator) {
    for (const char* text :
         {"x,f\n0.5,1\n0.25,2\n", "x;f\n0.5;1\n0.25 ; 2\n", "x\tf\n0.5\t1\n0.25\t2\n", "x f\n0.5 1\n 0.25   2 \n",
          "\"x\";\"f\"\n\"0.5\";1\n0.25;2\n", "x,\tf\n0.5,\t1\n0.25,2\n"}) {
        const NumberTable table = parse_csv(text, "points");
        EXPECT_THAT(table.header, ElementsAre("x", "f")) << text;
        EXPECT_THAT(table.values, ElementsAre(0.5, 1, 0.25, 2)) << text;
    }
    EXPECT_THAT(parse_csv("\"f(x,y)\",x\n1,2\n", "points").header, ElementsAre("f(x,y)", "x"));
}

TEST(ParseCsv, DoesNotReadADecimalComma) {
    EXPECT_THAT(complaint("x;f\n0,5;1\n"), AllOf(HasSubstr("points.csv:2: column 1 (x)"), HasSubstr("decimal point")));
}

TEST(ParseCsv, SkipsComments) {
    const NumberTable table =
        parse_csv("# drawn on Monday\n\nx,f\n0.5,1  # the first\n  # between\n0.25,2\n# end\n", "points");
    EXPECT_THAT(table.header, ElementsAre("x", "f"));
    EXPECT_THAT(table.values, ElementsAre(0.5, 1, 0.25, 2));
    EXPECT_EQ(table.line(1), 6u);
    EXPECT_EQ(table.where(1, 0), "points:6: column 1 (x)");
}

TEST(ParseCsv, TakesNamesFromTheCommentBeforeTheNumbers) {  // as numpy.savetxt writes them
    EXPECT_THAT(parse_csv("# made by me\n# f x\n1 0.5\n", "points").header, ElementsAre("f", "x"));
    EXPECT_THAT(parse_csv("# f,x\n1 0.5\n", "points").header, ElementsAre("f", "x"));
    EXPECT_THAT(parse_csv("x,f\n# f,x\n0.5,1\n", "points").header, ElementsAre("x", "f"));
    EXPECT_THAT(parse_csv("# made by me\n1 0.5\n", "points").header, ElementsAre());
}

TEST(ParseCsv, ReadsInfinitiesWhereTheyAreAccepted) {
    EXPECT_THAT(parse_csv("-inf,0\n0,inf\n", "cells", Numbers::extended).values,
                ElementsAre(-std::numeric_limits<double>::infinity(), 0, 0, std::numeric_limits<double>::infinity()));
    EXPECT_THROW(parse_csv("nan,0\n", "cells", Numbers::extended), Error);
}

const std::vector<ColumnNames> samples = {{"x", "f"}, {"x", "y", "f"}};

NumberTable ordered(std::string_view text) {
    return in_order(parse_csv(text, "points"), samples);
}
std::string misnamed(std::string_view text) {
    try {
        ordered(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(InOrder, FollowsTheNames) {
    EXPECT_THAT(ordered("f,x\n1,0.5\n2,0.25\n").values, ElementsAre(0.5, 1, 0.25, 2));
    EXPECT_THAT(ordered("y;F;X\n2;3;1\n").values, ElementsAre(1, 2, 3));
    EXPECT_THAT(ordered("y;F;X\n2;3;1\n").header, ElementsAre("x", "y", "f"));
    EXPECT_THAT(ordered("# f x\n3 1\n").values, ElementsAre(1, 3));
}

TEST(InOrder, TakesUnknownNamesAsTheyStand) {
    for (const char* text :
         {"0.5,1\n", "time,height\n0.5,1\n", "x,value\n0.5,1\n", "# two columns\n0.5,1\n", "# value x\n0.5,1\n"})
        EXPECT_THAT(ordered(text).values, ElementsAre(0.5, 1)) << text;
}

TEST(InOrder, RefusesNamesThatContradictTheirPlaces) {
    EXPECT_THAT(misnamed("value,x\n1,0.5\n"),
                HasSubstr("points: columns value,x found; accepted are 2 (x,f) and 3 (x,y,f), in any order"));
    for (const char* text : {"x,x\n1,2\n", "f,value\n1,2\n", "f,x,weight\n1,2,3\n"})
        EXPECT_THAT(misnamed(text), HasSubstr("found; accepted are 2 (x,f) and 3 (x,y,f)")) << text;
    EXPECT_THAT(misnamed("x,y,z,f\n1,2,3,4\n"), HasSubstr("4 columns found (x,y,z,f); accepted are 2 (x,f)"));
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
    EXPECT_THAT(complaint("a;b\n1\n"), HasSubstr("points.csv:2: 1 columns found; line 1 has 2"));
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
