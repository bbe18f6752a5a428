#include "studies/headline.h"

#include <gmock/gmock.h>

#include "core/test_folder.h"
#include "studies/measure.h"
#include "studies/study_file.h"

namespace plumb {
namespace {

using reports::Headline, reports::HeadlineOutcome;
using testing::AllOf, testing::ElementsAre, testing::HasSubstr, testing::Not;

const std::string study_text = R"(
title = "T"
source = "somebody 1999"
replicates = 500
[[figure]]
id = "a"
estimators = ["independent", "stratified", "halton", "voronoi"]
integrands = ["exp", "square"]
n = [4, 16, 64]
[[figure]]
id = "b"
estimators = ["independent", "yakowitz-trapezoid"]
integrands = ["exp"]
evaluations = [4, 16, 64]
[[headline]]
place = "Fig. 1"
states = "so"
)";

constexpr const char* slope = "figure = 'a'\nmeasure = 'slope'\nestimator = 'independent'\nintegrand = 'exp'\n";

HeadlinePlan parsed(const std::string& headline) {
    return parse_study(study_text + headline, "some/study.toml").headlines.at(0);
}

Headline measured(const std::string& headline) {
    const Study study = parse_study(study_text + headline, "some/study.toml");
    const auto figures = measure_study(study, Run(5, "study", 1), [](const auto&) {});
    return measure_headlines(study, figures).at(0);
}

std::string complaint(const std::string& headline) {
    const std::string message = error_of([&] { parsed(headline); });
    EXPECT_THAT(message, Not(HasSubstr("\n")));
    return message;
}

TEST(HeadlineFile, TakesTheWholeRangeOrTheLastCountUnlessToldOtherwise) {
    const HeadlinePlan whole = parsed(std::string(slope) + "at_most = -0.5\n");
    EXPECT_EQ(whole.source, "somebody 1999");
    EXPECT_EQ(whole.from, 4U);
    EXPECT_EQ(whole.to, 64U);
    EXPECT_EQ(whole.stated, (Interval{.high = -0.5}));
    const HeadlinePlan part = parsed(std::string(slope) + "over = [4, 16]\nbetween = [-2, 0]\nsource = 'us'\n");
    EXPECT_EQ(part.source, "us");
    EXPECT_EQ(part.to, 16U);
    EXPECT_EQ(part.stated, (Interval{-2, 0}));
    const HeadlinePlan last = parsed("figure = 'b'\nmeasure = 'mse'\nestimator = 'independent'\nat_least = 1\n");
    EXPECT_EQ(last.integrand, "exp");
    EXPECT_EQ(last.from, 64U);
    EXPECT_TRUE(last.in_evaluations);
}

TEST(HeadlineFile, IsComplainedAboutByLineAndKey) {
    const std::string good = slope;
    EXPECT_EQ(complaint(good + "at_most = 0\n"), "");
    EXPECT_EQ(complaint("not_comparable = 'its scenes are not ours'\n"), "");
    EXPECT_THAT(complaint("figure = 'c'\n"), HasSubstr("some/study.toml:18: headline.figure: unknown figure 'c'"));
    EXPECT_THAT(complaint("figure = 'a'\nmeasure = 'slop'\n"),
                HasSubstr(":19: headline.measure: unknown measure 'slop'; did you mean 'slope'"));
    EXPECT_THAT(complaint("figure = 'a'\nmeasure = 'mse'\nestimator = 'torus'\n"),
                HasSubstr("headline.estimator: 'torus' is not in the figure; accepted are independent, stratified"));
    EXPECT_THAT(complaint("figure = 'a'\nmeasure = 'mse'\nestimator = 'halton'\n"),
                HasSubstr("headline.integrand: is missing"));
    EXPECT_THAT(complaint(good), HasSubstr("headline.at_most: is missing"));
    EXPECT_THAT(complaint(good + "at_most = 0\nat_least = 1\n"), HasSubstr("at_least: stands beside at_most"));
    EXPECT_THAT(complaint(good + "between = [1, 0]\n"), HasSubstr("between: accepted are two numbers"));
    EXPECT_THAT(complaint(good + "at_most = inf\n"), HasSubstr("at_most: finite numbers are accepted"));
    EXPECT_THAT(complaint(good + "over = [4, 20]\nat_most = 0\n"),
                HasSubstr("headline.over: 20 is no count of the figure; accepted are 4, 16, 64"));
    EXPECT_THAT(complaint(good + "over = 4\nat_most = 0\n"), HasSubstr("over: accepted are two counts"));
    EXPECT_THAT(complaint("not_comparable = 'no'\nmeasure = 'mse'\n"), HasSubstr("unknown key 'headline.measure'"));
    EXPECT_THAT(complaint("figure = 'a'\nmeasure = 'relative_bias'\nestimator = 'voronoi'\nagainst = 'halton'\n"),
                HasSubstr("headline.against: a relative_bias stands for itself"));
}

TEST(Headline, IsMetOnlyWithinItsBoundAndUndecidedAcrossIt) {
    EXPECT_EQ(measured(std::string(slope) + "between = [-1.2, -0.8]\n").outcome, HeadlineOutcome::met);
    EXPECT_EQ(measured(std::string(slope) + "at_most = -2\n").outcome, HeadlineOutcome::not_met);
    EXPECT_EQ(measured(std::string(slope) + "at_most = -1\n").outcome, HeadlineOutcome::undecided);
}

TEST(Headline, ComparesEstimators) {
    const Headline ratio = measured(
        "figure = 'a'\nmeasure = 'mse'\nestimator = 'stratified'\nagainst = 'independent'\nintegrand = 'exp'\nat = 16\n"
        "at_most = 0.1\n");
    EXPECT_EQ(ratio.measure, "MSE of stratified / MSE of independent on exp, n = 16");
    EXPECT_NEAR(ratio.value, 1. / 256 * 1.03, 0.002);  // a stratum has 1/16² of the variance of the whole, nearly
    EXPECT_TRUE(ratio.interval.contains(ratio.value));
    EXPECT_EQ(ratio.outcome, HeadlineOutcome::met);
    const Headline difference = measured(std::string(slope) + "against = 'stratified'\nbetween = [1.7, 2.3]\n");
    EXPECT_EQ(difference.measure, "slope of the MSE of independent − that of stratified on exp, n = 4 to 64");
    EXPECT_EQ(difference.outcome, HeadlineOutcome::met);
}

TEST(Headline, TakesTheDifferenceOfRelativeErrors) {
    const std::string balance =
        "figure = 'a'\nmeasure = 'relative_mse'\nestimator = 'independent'\nintegrand = 'exp'\nat = 16\n";
    const Headline alone = measured(balance + "at_most = 1\n");
    EXPECT_NEAR(alone.value, 0.2420 / (1.71828 * 1.71828) / 16, 0.002);  // V[e^x] = 0.2420
    const Headline difference = measured(balance + "against = 'stratified'\nat_most = 0.01\n");
    EXPECT_EQ(difference.measure, "MSE / I² of independent − that of stratified on exp, n = 16");
    EXPECT_LT(difference.value, alone.value);
    EXPECT_FALSE(difference.logarithmic);
    EXPECT_EQ(difference.outcome, HeadlineOutcome::met);
}

TEST(HeadlineFile, TellsTheSourcesWordsFromOurs) {
    const std::string rest = "not_comparable = 'no'\n";
    EXPECT_FALSE(parsed(rest).quoted);
    std::string quoting = study_text;
    quoting.replace(quoting.find("states"), 6, "quotes");
    EXPECT_TRUE(parse_study(quoting + rest, "s.toml").headlines.at(0).quoted);
    EXPECT_THAT(complaint("quotes = 'so it is'\n" + rest), HasSubstr("headline.states: stands beside quotes"));
}

TEST(Headline, MeasuresTheSizeOfABias) {
    const std::string voronoi =
        "figure = 'a'\nmeasure = 'relative_bias'\nestimator = 'voronoi'\nintegrand = 'exp'\nat = 4\n";
    const Headline small = measured(voronoi + "at_most = 0.1\n");  // −0.7 %
    EXPECT_EQ(small.outcome, HeadlineOutcome::met);
    EXPECT_GE(small.interval.low, 0);
    EXPECT_EQ(measured(voronoi + "at_least = 0.1\n").outcome, HeadlineOutcome::not_met);
}

TEST(Headline, CountsEvaluationsWhereItsFigureDoes) {
    const Headline mse = measured(
        "figure = 'b'\nmeasure = 'mse'\nestimator = 'yakowitz-trapezoid'\nat = 64\nat_most = 1e-6\n");
    EXPECT_THAT(mse.measure, HasSubstr("evaluations = 64"));
    EXPECT_EQ(mse.outcome, HeadlineOutcome::met) << mse.reason;
}

TEST(Headline, SaysThatTailsLeaveASlopeUndecided) {
    const Headline heavy = measured(
        "figure = 'b'\nmeasure = 'slope'\nestimator = 'yakowitz-trapezoid'\nover = [16, 64]\nbetween = [-5, -3]\n");
    EXPECT_EQ(heavy.outcome, HeadlineOutcome::undecided);
    EXPECT_THAT(heavy.reason, HasSubstr("heavy tails"));
}

TEST(Headline, SaysWhyItCannotBeCompared) {
    const Headline deterministic =
        measured("figure = 'a'\nmeasure = 'mse'\nestimator = 'halton'\nintegrand = 'exp'\nat_most = 1\n");
    EXPECT_EQ(deterministic.outcome, HeadlineOutcome::not_comparable);
    EXPECT_THAT(deterministic.reason, HasSubstr("deterministic"));
    const Headline seconds =
        measured("figure = 'a'\nmeasure = 'seconds'\nestimator = 'voronoi'\nintegrand = 'exp'\nat_most = 1\n");
    EXPECT_EQ(seconds.outcome, HeadlineOutcome::not_comparable);
    EXPECT_GT(seconds.value, 0);
    const Headline elsewhere = measured("not_comparable = 'its scenes are not ours'\nremark = 'r'\n");
    EXPECT_EQ(elsewhere.reason, "its scenes are not ours");
    EXPECT_EQ(elsewhere.remark, "r");
    EXPECT_TRUE(std::isnan(elsewhere.value));
}

}  // namespace
}  // namespace plumb
