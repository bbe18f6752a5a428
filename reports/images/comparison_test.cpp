#include "reports/images/comparison.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "reports/page/browse.h"

namespace plumb::reports {
namespace {

using testing::AllOf, testing::HasSubstr, testing::Not;

/// Two pictures of 16x16 with constant channels; b is darker in the tile at (8, 8), and one pixel of it is not finite.
struct Sample {
    Picture a, b;
    ImageComparison found;

    Sample() : a(picture({0.5, 0.25, 0.125})), b(picture({0.5, 0.25, 0.125})) {
        for (int y = 8; y < 16; ++y)
            for (int x = 8; x < 16; ++x)
                for (std::size_t c = 0; c < 3; ++c) b.mean[b.at(x, y, c)] *= 0.5;
        for (std::size_t c = 0; c < 3; ++c) b.mean[b.at(0, 15, c)] = std::numeric_limits<double>::quiet_NaN();
        b.mean[b.at(1, 1, 0)] = 0.25;
        b.bad_pixels = 1;
        found = compare(a, b, {.tile = 8});
    }

    [[nodiscard]] ComparisonReport report() const {
        return {{"folder/one <script>.exr"}, {"b1.exr", "b2.exr"}, a, b, {.tile = 8}, found};
    }

private:
    static Picture picture(const std::vector<double>& colour) {
        Picture picture{.width = 16, .height = 16, .channels = {"R", "G", "B"}};
        for (int i = 0; i < 256; ++i)
            for (const double c : colour) {
                picture.mean.push_back(c);
                picture.variance.push_back(1e-4);
            }
        picture.degrees = 15;
        return picture;
    }
};

TEST(Comparison, IsWrittenAsJson) {
    const Sample sample;
    const auto json = nlohmann::json::parse(comparison_json(sample.report()));
    EXPECT_EQ(json["outcome"], "refuted");
    EXPECT_EQ(json["b"]["bad_pixels"], 1);
    EXPECT_EQ(json["tiles"].size(), 12U);
    ASSERT_EQ(json["differing"].size(), 3U);
    const auto& worst = json["tiles"][json["differing"][0].get<std::size_t>()];
    EXPECT_EQ(worst["x"], 8);
    EXPECT_EQ(worst["y"], 8);
    EXPECT_EQ(worst["state"], "differs");
    EXPECT_EQ(json["errors"][0]["name"], "RMSE");
    EXPECT_FALSE(json.contains("pixels"));
}

TEST(ComparisonPage, NeedsNothingFromElsewhere) {
    const std::string page = comparison_html(Sample().report());
    EXPECT_THAT(page, AllOf(HasSubstr("default-src 'none'"), Not(HasSubstr("{{")), HasSubstr("\\u003cscript>.exr")));
    EXPECT_FALSE(std::regex_search(page.substr(0, page.find("id=\"data\"")),
                                   std::regex(R"((src|href)\s*=\s*["']?\s*(https?:)?//)")));
}

TEST_F(PageInBrowser, ComparesPictures) {
    const Browsed page = browse(comparison_html(Sample().report()), "try_comparison.js", 1280);
    EXPECT_THAT(page.messages, Not(HasSubstr("CONSOLE")));
    EXPECT_EQ(page.saw("error"), "");
    EXPECT_EQ(page.saw("badge"), "✕ refuted");
    EXPECT_EQ(page.saw("sections"), "verdict pictures tiles channels errors");
    EXPECT_EQ(page.saw("overflow"), "0");
    EXPECT_EQ(page.saw("wrong-numbers"), "false");
    // In pixel (1, 1) a is (0.5, 0.25, 0.125), b (0.25, 0.25, 0.125); sRGB of ½, ¼ and ⅛ is 188, 137 and 99.
    EXPECT_EQ(page.saw("a"), "188,137,99");
    EXPECT_EQ(page.saw("b"), "137,137,99");
    EXPECT_EQ(page.saw("difference"), page.saw("third"));
    EXPECT_NE(page.saw("difference"), "235,235,235");  // a is brighter: towards red
    EXPECT_EQ(page.saw("z"), "200,30,20");             // 0.25/√(2e-4) is far beyond 5
    // 0.25/64 over √(2e-4/64) would be 2.2, but the dark tile beside it makes errors look correlated: z of 0.8.
    EXPECT_EQ(page.saw("tiles"), "229,202,201");
    EXPECT_EQ(page.saw("toggled"), "137,137,99");
    EXPECT_EQ(page.saw("back"), "188,137,99");
    EXPECT_EQ(page.saw("exposed"), "255,188,137");
    EXPECT_EQ(page.saw("wipe-left"), "188,137,99");
    EXPECT_EQ(page.saw("wipe-right"), "188,137,99");
    EXPECT_THAT(page.saw("place"), HasSubstr("Pixel (3, 2)"));
    EXPECT_EQ(page.saw("numbers"), "R 0.5 0.5 0 0.014099 0; G 0.25 0.25 0 0.014099 0; B 0.125 0.125 0 0.014099 0");
    EXPECT_EQ(page.saw("panes"), "2");
    EXPECT_EQ(page.saw("right-pane"), "137,137,99");
    EXPECT_EQ(page.saw("moved"), "true");
    EXPECT_EQ(page.saw("in-step"), "true");
    EXPECT_EQ(page.saw("first"), "(8, 8)");
    EXPECT_EQ(page.saw("zoomed"), "Pixel (12, 12)");
    EXPECT_EQ(page.saw("outlined"), "true");
}

/// The script clicks on views that are not there, and is stopped by that; what it saw before is the page.
TEST_F(PageInBrowser, ShowsPicturesWhoseErrorIsUnknownWithoutTests) {
    Sample sample;
    sample.b.error_known = false;
    sample.found = compare(sample.a, sample.b);
    const Browsed page = browse(comparison_html(sample.report()), "try_comparison.js", 1280);
    EXPECT_EQ(page.saw("badge"), "? undecided");
    EXPECT_EQ(page.saw("sections"), "verdict pictures channels errors");
    EXPECT_EQ(page.saw("overflow"), "0");
    EXPECT_EQ(page.saw("wrong-numbers"), "false");
}

TEST_F(PageInBrowser, ComparesPicturesOnAPhoneInTheDark) {
    const Browsed page =
        browse(comparison_html(Sample().report()), "try_comparison.js", 360, "--blink-settings=preferredColorScheme=0");
    EXPECT_THAT(page.messages, Not(HasSubstr("CONSOLE")));
    EXPECT_EQ(page.saw("error"), "");
    EXPECT_EQ(page.saw("overflow"), "0");
}

}  // namespace
}  // namespace plumb::reports
