#include "reports/study/svg_plot.h"

#include <gmock/gmock.h>

#include <regex>

namespace plumb::reports {
namespace {

using testing::HasSubstr, testing::Not;

/// Elements closed in order, attributes quoted, no bare '&' or '<'.
void expect_well_formed(const std::string& xml) {
    std::vector<std::string> open;
    const std::regex markup(R"(<(/?)(\w+)((?:\s+[\w:-]+=(?:'[^'<]*'|"[^"<]*"))*)\s*(/?)>)");
    std::string outside;
    std::size_t at = 0;
    for (std::sregex_iterator tag(xml.begin(), xml.end(), markup), end; tag != end; ++tag) {
        outside += xml.substr(at, static_cast<std::size_t>(tag->position()) - at);
        at = static_cast<std::size_t>(tag->position() + tag->length());
        if ((*tag)[1] == "/") {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ(open.back(), (*tag)[2]);
            open.pop_back();
        } else if ((*tag)[4] != "/") {
            open.push_back((*tag)[2]);
        }
    }
    outside += xml.substr(at);
    EXPECT_TRUE(open.empty());
    EXPECT_THAT(outside, Not(HasSubstr("<")));
    EXPECT_FALSE(std::regex_search(xml, std::regex("&(?!lt;|gt;|amp;|apos;|quot;)")));
}

SvgPlot sample() {
    return {.title = "Error <of> \"A & B\"",
            .subtitle = "it's exp",
            .x_label = "samples n",
            .y_label = "MSE",
            .powers_of_two = true,
            .lines = {{"A", 0, {{16, 1e-2, 9e-3, 2e-2}, {64, 1e-3, 9e-4, 2e-3}, {256, 1e-4, -1, 2e-4}}},
                      {"B & co", 9, {{16, 3e-2, 2e-2, 4e-2}, {64, 0, 0, 0}, {256, 1e-5, 1e-6, 1e-4}}}},
            .slopes = {-1, -3}};
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(SvgPlot, IsWellFormed) {
    expect_well_formed(to_svg(sample()));
}

TEST(SvgPlot, ShowsLinesBandsGuidesAndLegend) {
    const std::string svg = to_svg(sample());
    EXPECT_EQ(occurrences(svg, "<polyline"), 2U);
    EXPECT_EQ(occurrences(svg, "<polygon"), 2U);
    EXPECT_EQ(occurrences(svg, "stroke-width='1.5'"), 3U + 2 + 2);  // points (0 has no place) and legend
    EXPECT_EQ(occurrences(svg, "▽"), 1U);
    for (const char* text : {"B &amp; co", ">MSE<", ">samples n<", ">64<", "10⁻³", "−1</text>", "−3</text>",
                             "Error &lt;of&gt;", "it&apos;s exp"})
        EXPECT_THAT(svg, HasSubstr(text));
    EXPECT_THAT(svg, Not(testing::AnyOf(HasSubstr("nan"), HasSubstr("inf"))));
}

TEST(SvgPlot, OfNothingIsNoError) {
    SvgPlot plot = sample();
    plot.lines = {{"nothing to show", 0, {{1, 0, 0, 0}}}};
    const std::string svg = to_svg(plot);
    expect_well_formed(svg);
    EXPECT_THAT(svg, Not(testing::AnyOf(HasSubstr("nan"), HasSubstr("inf"))));
}

TEST(SvgPlot, OfOnePointHasTicks) {
    SvgPlot plot = sample();
    plot.lines = {{"one", 0, {{3, 0.2, 0.2, 0.2}}}};
    const std::string svg = to_svg(plot);
    expect_well_formed(svg);
    EXPECT_THAT(svg, HasSubstr(">0.2<"));
}

}  // namespace
}  // namespace plumb::reports
