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

TEST(Differences, TurnRoundWithTheRuns) {
    const Differences there = diff_runs(earlier_sample_results(), sample_results());
    const Differences back = diff_runs(sample_results(), earlier_sample_results());
    EXPECT_EQ(there.added, back.removed);
    EXPECT_EQ(there.removed, back.added);
    EXPECT_EQ(there.claims[0].before, back.claims[0].after);
}

}  // namespace
}  // namespace plumb::reports
