#include "verification/evidence/deterministic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumb {
namespace {

using testing::HasSubstr;

TEST(WithinBound, NamesTheWorstCase) {
    const Verdict verdict = within_bound({{"small", 0.5}, {"large", 3}}, 2, "ulp");
    EXPECT_EQ(verdict.outcome, Outcome::refuted);
    EXPECT_THAT(verdict.reason, HasSubstr("large"));
    EXPECT_EQ(within_bound({{"small", 0.5}}, 2, "ulp").outcome, Outcome::holds);
}

TEST(WithinBound, NanRefutesAndNothingDecidesNothing) {
    EXPECT_EQ(within_bound({{"fine", 0}, {"nan", std::nan("")}}, 2, "ulp").outcome, Outcome::refuted);
    EXPECT_EQ(within_bound({}, 2, "ulp").outcome, Outcome::undecided);
}

TEST(Exactly, Decides) {
    EXPECT_EQ(exactly(true, 8, "all equal").outcome, Outcome::holds);
    EXPECT_EQ(exactly(false, 8, "case 3: 1 is not 2").outcome, Outcome::refuted);
}

TEST(CostIs, ComparesCounts) {
    EXPECT_EQ(cost_is(3, {3, 3}, "evaluations").outcome, Outcome::holds);
    EXPECT_EQ(cost_is(4, {3, 3}, "evaluations").outcome, Outcome::refuted);
}

TEST(OutcomeIs, TurnsADemandedOutcomeIntoHolds) {
    Verdict inner;
    EXPECT_EQ(outcome_is(inner, Outcome::undecided).outcome, Outcome::holds);
    EXPECT_EQ(outcome_is(inner, Outcome::refuted).outcome, Outcome::refuted);
}

TEST(UlpError, CountsUnitsInTheLastPlace) {
    EXPECT_EQ(ulp_error(1, 1), 0);
    EXPECT_EQ(ulp_error(std::nextafter(1.0, 2.0), 1), 1);
    EXPECT_EQ(ulp_error(-3, std::nextafter(-3.0, 0.0)), 1);
    EXPECT_EQ(ulp_error(0, 0x1p-1074), 1);
    EXPECT_EQ(ulp_error(std::nan(""), 1), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace plumb
