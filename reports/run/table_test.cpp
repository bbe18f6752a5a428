#include "reports/run/table.h"

#include <gmock/gmock.h>

#include <sstream>

#include "reports/run/sample_results.h"
#include "reports/text/text.h"

namespace plumb::reports {
namespace {

using testing::AllOf, testing::EndsWith, testing::HasSubstr, testing::Not;

TEST(VerdictTable, HasOneLineAClaimTheLivingMutantsAndTheSummary) {
    const std::string text = verdict_table(sample_results(), {.colour = false, .width = TableStyle::unlimited});
    for (const ClaimResult& claim : sample_results().claims) EXPECT_THAT(text, HasSubstr(claim.id));
    EXPECT_THAT(text, AllOf(HasSubstr("lives   mis/one-sample/distribution/swapped"), Not(HasSubstr("clipped")),
                            EndsWith("\n9 hold, 2 refuted, 1 undecided; mutants: 3 of 4 refuted\n")));
}

TEST(VerdictTable, KeepsToTheWidthAndIsPlainUnlessAsked) {
    const std::string text = verdict_table(sample_results(), {.colour = false, .width = 120});
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(columns_of(line), 120U) << line;
    EXPECT_THAT(text, Not(HasSubstr("\033")));
    EXPECT_THAT(verdict_table(sample_results(), {.colour = true}), HasSubstr("\033[1;31mrefuted"));
}

TEST(VerdictTable, KeepsReasonsRatherThanIdsOnATerminal) {
    Results results = sample_results();
    results.claims[0].id = "reweighting/a-group/with-names/that-go-on/and-on/and-on/to-the-end";
    results.claims[0].verdict.reason = "a reason of some length, of which the beginning says what it is about";
    const std::string narrow = verdict_table(results, {.colour = false, .width = 100});
    EXPECT_THAT(narrow, AllOf(HasSubstr("to-the-end"), Not(HasSubstr(results.claims[0].id)),
                              HasSubstr("a reason of some len")));
    const std::string pipe = verdict_table(results, {.colour = false, .width = TableStyle::unlimited});
    EXPECT_THAT(pipe, AllOf(HasSubstr(results.claims[0].id), HasSubstr(results.claims[0].verdict.reason)));
}

TEST(ListTable, ShortensOnATerminalAlone) {
    const std::string text(60, 'w');
    const std::vector<ListRow> rows = {{{"id", std::string("a")}, {"statement", text}, {"source", std::string("s")}}};
    EXPECT_THAT(list_table(rows), Not(HasSubstr(text)));
    EXPECT_THAT(list_table(rows, {.colour = false, .width = TableStyle::unlimited}), HasSubstr(text));
}

TEST(ConvergeTable, HasPointsAndTheSlopeAgainstTheory) {
    const std::string text = converge_table(sample_results().claims[6].verdict.series);
    EXPECT_THAT(text,
                AllOf(HasSubstr("independent on exp, 1000 replicates"), HasSubstr("65536"),
                      HasSubstr("slope -0.98 [-1.02, -0.94], meets the expected -1"), HasSubstr("nothing expected")));
}

TEST(DifferencesTable, SaysWhatChanged) {
    const Differences d = diff_runs(earlier_sample_results(), sample_results());
    EXPECT_THAT(differences_table(d), AllOf(HasSubstr("reweighting/torus/unbiased  undecided  holds"),
                                            HasSubstr("added  mis/cutoff/cost"), HasSubstr("removed  mis/maximum")));
    EXPECT_THAT(differences_table({}), HasSubstr("no differences"));
}

TEST(RunsTable, HasOneLineARun) {
    const std::vector<StoredRun> runs = {{3, sample_results().run, tally(sample_results())}};
    EXPECT_THAT(runs_table(runs), AllOf(HasSubstr("2025-01-31T23:59:59Z"), HasSubstr("3 of 4")));
}

TEST(ListTable, TakesItsHeadingsFromTheFirstRow) {
    const std::vector<ListRow> rows = {{{"id", std::string("exp")},
                                        {"dimension", std::uint64_t{1}},
                                        {"variance", 0.242},
                                        {"formula", std::string("e^x")}},
                                       {{"id", std::string("a-longer-id")},
                                        {"dimension", std::uint64_t{2}},
                                        {"variance", 10.5},
                                        {"formula", std::string("f")}}};
    EXPECT_EQ(list_table(rows),
              "id           dimension  variance  formula\n"
              "exp                  1     0.242  e^x\n"
              "a-longer-id          2      10.5  f\n");
    EXPECT_EQ(list_table({}), "");
}

}  // namespace
}  // namespace plumb::reports
