#include "reports/run/json.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/test_folder.h"
#include "reports/run/sample_results.h"

namespace plumb::reports {
namespace {

using testing::AllOf, testing::HasSubstr, testing::IsEmpty, testing::Not;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

TEST(Json, OfARunReadsBackAsTheSameText) {
    const std::string text = to_json(sample_results());
    EXPECT_EQ(to_json(results_from_json(text, "sample")), text);
}

TEST(Json, KeepsEveryNumberToTheBit) {
    Results results = sample_results();
    results.run.seed = std::numeric_limits<std::uint64_t>::max();
    results.run.alpha = 0.1 + 0.2;
    results.claims[0].verdict.statistic = 5e-324;
    results.claims[0].verdict.p_value = unknown;
    results.claims[0].verdict.deviation = {-infinity, 1.0 / 3};
    const Results back = results_from_json(to_json(results), "sample");
    EXPECT_EQ(back.run.seed, results.run.seed);
    EXPECT_EQ(back.run.alpha, results.run.alpha);
    EXPECT_EQ(back.claims[0].verdict.statistic, 5e-324);
    EXPECT_TRUE(std::isnan(back.claims[0].verdict.p_value));
    EXPECT_EQ(back.claims[0].verdict.deviation, (Interval{-infinity, 1.0 / 3}));
}

TEST(Json, KeepsTheEvidenceInOrderAndItsTypes) {
    Results results = sample_results();
    results.claims[0].verdict.evidence = {{"zeta", 3.0},
                                          {"alpha", std::uint64_t{3}},
                                          {"text", std::string("Σ|V| \"quoted\" </script>")},
                                          {"list", std::vector<double>{1, -infinity}}};
    const Results back = results_from_json(to_json(results), "sample");
    EXPECT_EQ(back.claims[0].verdict.evidence, results.claims[0].verdict.evidence);
}

TEST(Json, KeepsSeriesAndStability) {
    const Results results = sample_results(), back = results_from_json(to_json(results), "sample");
    const Series& series = results.claims[6].verdict.series[7];
    const Series& read = back.claims[6].verdict.series[7];
    EXPECT_EQ(read.estimator, "Halton, randomly shifted");
    EXPECT_FALSE(read.expected_slope);
    EXPECT_EQ(read.points[1].mse_interval, series.points[1].mse_interval);
    EXPECT_EQ(read.points[6].bias_standard_error, series.points[6].bias_standard_error);
    EXPECT_EQ(back.claims[6].verdict.series[0].expected_slope, (Interval{-1, -1}));
    EXPECT_EQ(back.claims[8].verdict.stability[0].points.size(), results.claims[8].verdict.stability[0].points.size());
    EXPECT_EQ(back.claims[8].verdict.stability[0].points[0].x, 0x1p-1074);
}

TEST(Json, HasTheDocumentedKeys) {
    const std::string text = to_json(sample_results());
    for (const char* key : {"run", "seed", "alpha", "threads", "version", "started", "seconds", "claims", "id",
                            "statement", "source", "kind", "outcome", "samples", "evidence", "mutants", "of", "killed"})
        EXPECT_THAT(text, HasSubstr("\"" + std::string(key) + "\": "));
    EXPECT_THAT(text, AllOf(HasSubstr("\"outcome\": \"refuted\""), HasSubstr("\"largest\": \"inf\""),
                            HasSubstr("\"not_measured\": null"), Not(HasSubstr("nan"))));
}

TEST(Json, ReplacesBytesThatAreNotUtf8) {
    Results results = sample_results();
    results.run.patterns = "caf\xe9";
    EXPECT_EQ(results_from_json(to_json(results), "sample").run.patterns, "caf\xef\xbf\xbd");
}

TEST(Json, OfConvergeHasSeriesWithPointsAndSlope) {
    const Results results = sample_results();
    const std::string text = converge_json(results.run, results.claims[6].verdict.series, {});
    for (const char* key : {"series", "estimator", "integrand", "points", "n", "evaluations", "seconds", "mse",
                            "mse_low", "mse_high", "bias", "bias_standard_error", "slope", "value", "low", "high"})
        EXPECT_THAT(text, HasSubstr("\"" + std::string(key) + "\": "));
}

TEST(Json, OfAListIsAnArrayWithTheFieldsInOrder) {
    const std::vector<ListRow> rows = {
        {{"id", std::string("exp")}, {"dimension", std::uint64_t{1}}, {"variance", infinity}}};
    EXPECT_EQ(list_json(rows),
              "[\n  {\n    \"id\": \"exp\",\n    \"dimension\": 1,\n    \"variance\": \"inf\"\n  }\n]\n");
    EXPECT_EQ(list_json({}), "[]\n");
}

TEST(Json, ThatIsNoRunIsAnErrorNamingTheFile) {
    for (const std::string text : {"", "{", "[]", "{\"run\": 3}", "null"}) {
        EXPECT_THAT(error_of([&] { (void)results_from_json(text, "old.json"); }),
                    AllOf(HasSubstr("old.json: not the JSON of a run"), Not(HasSubstr("\n"))))
            << text;
        EXPECT_THROW((void)results_from_json(text, "old.json"), Error);
    }
}

TEST(Json, WithAnUnknownOutcomeSaysWhatIsAccepted) {
    std::string text = to_json(sample_results());
    text.replace(text.find("\"refuted\""), 9, "\"passed\"");
    EXPECT_THAT(error_of([&] { (void)results_from_json(text, "x"); }), HasSubstr("unknown outcome 'passed'"));
}

}  // namespace
}  // namespace plumb::reports
