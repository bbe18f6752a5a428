#include "reports/run/html.h"
#include "reports/study/study_page.h"

#include <gmock/gmock.h>

#include <regex>

#include "core/file.h"
#include "core/test_folder.h"
#include "reports/page/browse.h"
#include "reports/run/sample_results.h"

namespace plumb::reports {
namespace {

using testing::AllOf, testing::HasSubstr, testing::Not;

std::string sample_page() {
    return report_html(sample_results(), earlier_sample_results());
}

std::size_t occurrences(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(Page, HoldsTheDataAndNothingFromElsewhere) {
    const std::string page = sample_page();
    EXPECT_THAT(page, AllOf(HasSubstr("reweighting/torus/unbiased-2d"), HasSubstr("\"seed\":\"17592186044416123457\""),
                            HasSubstr("default-src 'none'"), Not(HasSubstr("{{"))));
    const std::string head = page.substr(0, page.find("id=\"data\""));
    EXPECT_FALSE(std::regex_search(head, std::regex(R"((src|href)\s*=\s*["']?\s*(https?:)?//)")));
    EXPECT_EQ(occurrences(page, "<script src"), 0U);
    EXPECT_EQ(occurrences(page, "rel=\"stylesheet\""), 0U);
    EXPECT_EQ(occurrences(page, "@import"), 0U);
}

TEST(Page, CannotBeBrokenOutOfByTheData) {
    EXPECT_THAT(sample_page(), AllOf(Not(HasSubstr("<script>alert(1)")), HasSubstr("\\u003cscript>alert(1)")));
    EXPECT_EQ(occurrences(sample_page(), "</script>"), 4U);
}

TEST(Page, OfConvergeHasNoVerdicts) {
    const TestFolder folder;
    const Results results = sample_results();
    write_file(folder / "converge.html", converge_report_html(results.run, results.claims[6].verdict.series));
    EXPECT_THAT(read_file(folder / "converge.html"),
                AllOf(HasSubstr("<title>Plumb: convergence"), HasSubstr("\"claims\":[]")));
}

// ---- in a browser

Browsed browse(const std::string& page, int width, const std::string& options = "") {
    return plumb::reports::browse(page, "try_everything.js", width, options);
}

TEST_F(PageInBrowser, DrawsItsPlotsAndSurvivesEveryControl) {
    const Browsed page = browse(sample_page(), 1280);
    EXPECT_THAT(page.messages, Not(HasSubstr("CONSOLE")));
    EXPECT_EQ(page.saw("width"), "1280");
    EXPECT_EQ(page.saw("error"), "");
    EXPECT_EQ(page.saw("plots"), "3");  // convergence, work, stability
    EXPECT_EQ(page.saw("plots-after"), "3");
    EXPECT_EQ(page.saw("overflow"), "0");
    EXPECT_EQ(page.saw("csv-rows"), "64");  // 9 estimators at 7 sample counts, and the headings
    EXPECT_EQ(page.saw("svg"), "svg, drawn, alone");
    EXPECT_EQ(page.saw("found"), "2");
    EXPECT_THAT(page.saw("opened"), HasSubstr("mis/balance/corners"));
    EXPECT_EQ(page.saw("wrong-numbers"), "false");
    EXPECT_EQ(page.saw("sections"), "overview differences verdicts convergence work stability mutants errata sources");
    EXPECT_EQ(page.saw("dead-links"), "0");
    EXPECT_EQ(page.saw("clamped"), "true");
    EXPECT_EQ(page.saw("escaped"), "true");
}

TEST_F(PageInBrowser, FitsAPhone) {
    const Browsed page = browse(sample_page(), 360, "--blink-settings=preferredColorScheme=0");
    EXPECT_THAT(page.messages, Not(HasSubstr("CONSOLE")));
    EXPECT_EQ(page.saw("width"), "360");
    EXPECT_EQ(page.saw("overflow"), "0");
    EXPECT_EQ(page.saw("plots"), "3");
}

TEST_F(PageInBrowser, DrawsConvergenceAlone) {
    const Results sample = sample_results();
    const Browsed page = browse(report_html({.run = sample.run, .series = sample.claims[6].verdict.series}), 1280);
    EXPECT_THAT(page.messages, Not(HasSubstr("CONSOLE")));
    EXPECT_EQ(page.saw("plots"), "2");
    EXPECT_EQ(page.saw("sections"), "convergence work");
}

TEST_F(PageInBrowser, DrawsAStudy) {
    const std::vector<Series> series = sample_results().claims[6].verdict.series;
    StudyResult study{.run = sample_results().run, .about = {"s", "A </script> study", "Text.", "ours"}, .figures = {}};
    study.figures.push_back({{.id = "first", .title = "First", .source_says = "so", .slopes = {-1, -2}},
                             {{"exp", 1.7, {series[0], series[1]}}, {"sine", 0, {series[2]}}}});
    study.figures.push_back(
        {{.id = "second", .title = "Second", .metrics = {metric_from("bias"), metric_from("efficiency")}},
         {{"exp", 1.7, {series[0]}}}});
    for (const int width : {1280, 360}) {
        const Browsed page = browse(study_html(study), width);
        EXPECT_THAT(page.messages, Not(HasSubstr("CONSOLE")));
        EXPECT_EQ(page.saw("error"), "");
        EXPECT_EQ(page.saw("plots"), "4");
        EXPECT_EQ(page.saw("plots-after"), "4");
        EXPECT_EQ(page.saw("overflow"), "0");
        EXPECT_EQ(page.saw("sections"), "about first second");
        EXPECT_EQ(page.saw("wrong-numbers"), "false");
    }
}

/// A statement that the MSE's ratio is at most 1, and what was measured.
Headline ratio(std::string source, double value, bool quoted) {
    return {.source = std::move(source),
            .place = "Fig. 1",
            .states = "So it is.",
            .quoted = quoted,
            .figure = "first",
            .measure = "MSE of a / MSE of b",
            .stated = {.high = 1},
            .value = value,
            .interval = {0.8 * value, 1.25 * value},
            .logarithmic = true,
            .outcome = outcome_of({.high = 1}, {0.8 * value, 1.25 * value})};
}

TEST_F(PageInBrowser, LaysStatementsBesideMeasurementsBySource) {
    StudyResult study{
        .run = sample_results().run,
        .about = {"s", "What papers promise", "Text.", "", true},
        .figures = {},
        .headlines = {ratio("[Owen 1997]", 0.5, true), ratio("ours, on [Veach 1997, section 9.2]", 3, false)}};
    study.figures.push_back(
        {{.id = "first", .title = "One: first"}, {{"exp", 1.7, {sample_results().claims[6].verdict.series}}}});
    for (const int width : {1280, 360}) {
        const Browsed page = browse(study_html(study), width);
        EXPECT_THAT(page.messages, Not(HasSubstr("CONSOLE")));
        EXPECT_EQ(page.saw("error"), "");
        EXPECT_EQ(page.saw("overflow"), "0");
        EXPECT_EQ(page.saw("sections"), "about headlines first sources");
        EXPECT_EQ(page.saw("statements"), "“So it is.” So it is.");
        EXPECT_EQ(page.saw("bands"), "2") << "a bound without a lower end is drawn too";
        EXPECT_EQ(page.saw("dead-links"), "0");
        EXPECT_EQ(page.saw("wrong-numbers"), "false");
    }
}

TEST_F(PageInBrowser, OfAnEmptyRunIsNoError) {
    const Browsed page = browse(report_html({}), 1280);
    EXPECT_THAT(page.messages, Not(HasSubstr("CONSOLE")));
    EXPECT_EQ(page.saw("width"), "1280");
}

}  // namespace
}  // namespace plumb::reports
