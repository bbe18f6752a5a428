#include "reports/run/differences.h"

#include <gmock/gmock.h>

#include "reports/run/sample_results.h"

namespace plumb::reports {
namespace {

using testing::ElementsAre, testing::IsEmpty;

TEST(Differences, AreNoneBetweenARunAndItself) {
    EXPECT_TRUE(diff_runs(sample_results(), sample_results()).empty());
}

TEST(Differences, ListWhatChangedCameAndWent) {
    const Differences d = diff_runs(earlier_sample_results(), sample_results());
    ASSERT_EQ(d.claims.size(), 1U);
    EXPECT_EQ(d.claims[0].id, "reweighting/torus/unbiased");
    EXPECT_EQ(d.claims[0].before, Outcome::undecided);
    EXPECT_EQ(d.claims[0].after, Outcome::holds);
    EXPECT_THAT(d.added, ElementsAre("mis/cutoff/cost"));
    EXPECT_THAT(d.removed, ElementsAre("mis/maximum/sums"));
    EXPECT_THAT(d.added_mutants, ElementsAre("mis/one-sample/distribution/swapped"));
    EXPECT_THAT(d.removed_mutants, IsEmpty());
    EXPECT_FALSE(d.empty());
}

TEST(Differences, AreOfWhatBothRunsWereAskedFor) {
    Results part = sample_results();
    part.run.patterns = "mis/*";
    std::erase_if(part.claims, [](const ClaimResult& claim) { return !claim.id.starts_with("mis/"); });
    std::erase_if(part.mutants, [](const MutantResult& mutant) { return !mutant.of.starts_with("mis/"); });
    const Differences d = diff_runs(earlier_sample_results(), part);
    EXPECT_THAT(d.claims, IsEmpty());
    EXPECT_THAT(d.added, ElementsAre("mis/cutoff/cost"));
    EXPECT_THAT(d.removed, ElementsAre("mis/maximum/sums"));
    EXPECT_THAT(d.removed_mutants, IsEmpty());
    EXPECT_GT(d.not_asked, 5U);
    for (const auto& change : {+[](RunInfo& run) { run.shards = 2; }, +[](RunInfo& run) { run.finished = false; },
                               +[](RunInfo& run) { run.size = "full"; }}) {
        change(part.run);
        EXPECT_THAT(diff_runs(earlier_sample_results(), part).removed, IsEmpty());
        part.run = sample_results().run;
    }
}

TEST(Differences, TurnRoundWithTheRuns) {
    const Differences there = diff_runs(earlier_sample_results(), sample_results());
    const Differences back = diff_runs(sample_results(), earlier_sample_results());
    EXPECT_EQ(there.added, back.removed);
    EXPECT_EQ(there.removed, back.added);
    EXPECT_EQ(there.claims[0].before, back.claims[0].after);
}

}  // namespace
}  // namespace plumb::reports
