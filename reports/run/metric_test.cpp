#include "reports/run/metric.h"

#include <gmock/gmock.h>

#include "core/test_folder.h"
#include "reports/study/study_result.h"

namespace plumb::reports {
namespace {

constexpr ConvergencePoint point{
    .n = 10, .evaluations = 20, .seconds = 0.5, .mse = 4, .mse_interval = {1, 9}, .bias = -1, .bias_standard_error = 2};

void expect(const Measured& m, double value, double low, double high) {
    EXPECT_DOUBLE_EQ(m.value, value);
    EXPECT_DOUBLE_EQ(m.low, low);
    EXPECT_DOUBLE_EQ(m.high, high);
}

TEST(Metric, IsAFunctionOfThePoint) {
    expect(measured(metric_from("mse"), point, 2, Work::n), 4, 1, 9);
    expect(measured(metric_from("rmse"), point, 2, Work::n), 2, 1, 3);
    expect(measured(metric_from("relative_mse"), point, -2, Work::n), 1, 0.25, 2.25);
    expect(measured(metric_from("efficiency"), point, 2, Work::n), 1. / 80, 1. / 180, 1. / 20);
    expect(measured(metric_from("efficiency"), point, 2, Work::seconds), 0.5, 1 / 4.5, 2);
    const Measured bias = measured(metric_from("bias"), point, 2, Work::n);
    EXPECT_EQ(bias.value, 1);
    EXPECT_NEAR(bias.low, 1 - 3.92, 1e-3);
    EXPECT_NEAR(bias.high, 1 + 3.92, 1e-3);
}

TEST(Metric, GoesByItsName) {
    for (const ErrorMetric& metric : error_metrics()) EXPECT_EQ(&entry(metric_from(metric.name)), &metric);
    for (const Work w : {Work::n, Work::evaluations, Work::seconds}) EXPECT_EQ(work_from(to_string(w)), w);
    EXPECT_THAT(error_of([] { metric_from("biass"); }), testing::HasSubstr("did you mean 'bias'"));
}

TEST(EstimatorStyles, DifferInEveryFigureWhileColoursLast) {
    const auto figure = [](std::initializer_list<const char*> names) {
        FigureResult result;
        FigurePanel& panel = result.panels.emplace_back();
        for (const char* name : names) panel.series.emplace_back().estimator = name;
        return result;
    };
    StudyResult study;
    study.figures = {figure({"a", "b", "c", "d", "e", "f", "g", "h"}), figure({"a", "x", "c"}), figure({"x", "b"})};
    const std::vector<EstimatorStyle> styles = estimator_styles(study);
    ASSERT_EQ(styles.size(), 9U);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(styles[i].style, i);
    EXPECT_EQ(styles[8].estimator, "x");
    EXPECT_EQ(styles[8].style, 9U);  // 8 would have the colour of "a"
}

}  // namespace
}  // namespace plumb::reports
