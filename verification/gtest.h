#pragma once

#include <gtest/gtest.h>

#include <string>

#include "verification/trial.h"
#include "verification/verdict.h"

// Verdicts as assertions of a GoogleTest suite:
//
//   TEST(Disk, IsUniform) {
//       EXPECT_TRUE(plumb::holds(plumb::distribution_is(draw_cell, claim, plumb::trial())));
//   }
//
// A failure says what was found and with which PLUMB_SEED it is found again.
namespace plumb {

/// A trial named after the test that is running. A test with several trials names them: trial("direction").
inline Run trial(double alpha = trial_alpha) {
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    return trial(test ? std::string(test->test_suite_name()) + "." + test->name() : "outside of a test", alpha);
}

/// The assertion that succeeds only for `holds`: a claim that is undecided has not been shown.
inline testing::AssertionResult holds(const Verdict& verdict) {
    testing::AssertionResult result(verdict.outcome == Outcome::holds);
    return result << describe(verdict) << "; again with PLUMB_SEED=" << trial_seed();
}

}  // namespace plumb
