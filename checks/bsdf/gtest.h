#pragma once

#include "checks/bsdf/check_bsdf.h"
#include "verification/gtest.h"

// A model's verdicts as assertions of a GoogleTest suite:
//
//   TEST(Glass, IsTrue) {
//       EXPECT_TRUE(plumb::holds(plumb::checks::check_bsdf(Glass{}, {.eta = 1.5}, plumb::trial())));
//   }
namespace plumb {

/// The assertion that succeeds only where every property holds; a failure lists all that do not, a line each.
inline testing::AssertionResult holds(const std::vector<checks::NamedVerdict>& verdicts) {
    testing::AssertionResult result(true);
    for (const checks::NamedVerdict& named : verdicts) {
        if (named.verdict.outcome == Outcome::holds) continue;
        result = testing::AssertionFailure() << result.message() << "\n  " << named;
    }
    return result << "\n  again with PLUMB_SEED=" << trial_seed();
}

}  // namespace plumb
