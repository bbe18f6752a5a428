#include "verification/trial.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/error.h"
#include "verification/evidence/mean.h"
#include "verification/gtest.h"

namespace plumb {
namespace {

using testing::HasSubstr;

const Draw fair = [](RandomStream& random) { return random.uniform() < 0.5 ? 1.0 : 0.0; };

Verdict fair_coin_has_mean(double reference) {
    return mean_is(fair, {.reference = reference, .delta = 0.02, .bounds = {0, 1}}, trial());
}

TEST(Trial, IsNamedAfterItsTest) {
    EXPECT_EQ(trial().random(0).bits(), trial("Trial.IsNamedAfterItsTest").random(0).bits());
    EXPECT_EQ(trial().alpha(), trial_alpha);
    EXPECT_EQ(trial(0.5).alpha(), 0.5);
}

TEST(Trial, KeepsItsSeed) {
    EXPECT_EQ(trial_seed(), trial_seed());
}

TEST(TrialDeathTest, TakesItsSeedFromTheEnvironment) {  // in a process of its own: the seed is read once
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    setenv("PLUMB_SEED", "417", 1);
    EXPECT_EXIT(std::exit(trial_seed() == 417 ? 0 : 1), testing::ExitedWithCode(0), "");
    setenv("PLUMB_SEED", "41x", 1);
    EXPECT_EXIT(
        {
            try {
                (void)trial_seed();
            } catch (const Error& error) {
                std::fputs(error.what(), stderr);
                std::exit(2);
            }
        },
        testing::ExitedWithCode(2), "PLUMB_SEED is '41x'");
    unsetenv("PLUMB_SEED");
}

TEST(Holds, IsTrueForAVerdictThatHolds) {
    EXPECT_TRUE(holds(fair_coin_has_mean(0.5)));
}

TEST(Holds, SaysWhatWasFoundAndHowToFindItAgain) {
    const testing::AssertionResult result = holds(fair_coin_has_mean(0.6));
    EXPECT_FALSE(result);
    EXPECT_THAT(result.message(), HasSubstr("refuted: mean 0."));
    EXPECT_THAT(result.message(), HasSubstr("PLUMB_SEED=" + std::to_string(trial_seed())));
}

TEST(Holds, IsFalseForWhatIsUndecided) {
    EXPECT_FALSE(holds(Verdict()));
}

}  // namespace
}  // namespace plumb
