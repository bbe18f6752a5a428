#include "studies/measure.h"

#include <gmock/gmock.h>

#include "core/file.h"
#include "core/parallel.h"
#include "core/test_folder.h"
#include "reports/study/study_files.h"
#include "studies/study_file.h"

namespace plumb {
namespace {

using testing::AllOf, testing::ElementsAre, testing::EndsWith, testing::HasSubstr, testing::StartsWith;

constexpr const char* tiny = R"(
title = "A tiny study"
replicates = 200
n = [4, 8, 16]

[[figure]]
id = "errors"
estimators = ["independent", "torus", "voronoi"]
integrands = ["exp", "square"]
metrics = ["mse", "bias"]
slopes = [-1]

[[figure]]
id = "image"
estimators = ["independent"]
integrands = ["exp-sum"]
)";

reports::StudyResult measured_study(int threads = 1) {
    const Study study = parse_study(tiny, "tiny.toml");
    reports::StudyResult result{.run = {}, .about = study.about, .figures = {}};
    with_threads(threads, [&] { result.figures = measure_study(study, Run(5, "study", 1), [](const auto&) {}); });
    return result;
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> list;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find("\r\n", at);
        list.push_back(text.substr(at, end - at));
        at = end + 2;
    }
    return list;
}

TEST(MeasureStudy, MeasuresEveryEstimatorOnEveryIntegrand) {
    const reports::StudyResult result = measured_study();
    ASSERT_EQ(result.figures.size(), 2U);
    ASSERT_EQ(result.figures[0].panels.size(), 2U);
    const reports::FigurePanel& exponential = result.figures[0].panels[0];
    EXPECT_EQ(exponential.integrand, "exp");
    EXPECT_DOUBLE_EQ(exponential.integral, std::exp(1.0) - 1);
    ASSERT_EQ(exponential.series.size(), 3U);
    const Series& independent = exponential.series[0];
    ASSERT_EQ(independent.points.size(), 3U);
    const double variance = find_integrand<1>("exp").variance_value();
    EXPECT_NEAR(independent.points[2].mse, variance / 16, 5 * independent.points[2].log_mse_error * variance / 16);
    EXPECT_EQ(result.figures[1].panels[0].series[0].integrand, "exp-sum");
}

TEST(MeasureStudy, GivesTheSameNumbersOnAnyNumberOfThreads) {
    const reports::StudyResult one = measured_study(1), two = measured_study(2);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(one.figures[0].panels[1].series[1].points[i].mse, two.figures[0].panels[1].series[1].points[i].mse);
}

TEST(SamplesWithin, IsTheLargestCountThatStaysWithin) {
    const Integrand<1>& f = find_integrand<1>("exp");
    const plumb::Run run(1, "test", 1);
    EXPECT_EQ(samples_within(100, find_estimator<1>("torus"), f, run), 100U);
    EXPECT_EQ(samples_within(100, find_estimator<1>("yakowitz-trapezoid"), f, run), 98U);
    EXPECT_EQ(samples_within(2, find_estimator<1>("yakowitz-trapezoid"), f, run), 1U);
}

TEST(StudyFiles, AreAPageATableAndPlots) {
    const std::vector<reports::FolderFile> files = reports::study_files(measured_study());
    std::vector<std::string> names;
    for (const reports::FolderFile& file : files) names.push_back(file.name);
    EXPECT_THAT(names, ElementsAre("index.html", "series.csv", "errors-exp-mse.svg", "errors-exp-bias.svg",
                                   "errors-square-mse.svg", "errors-square-bias.svg", "image.svg"));
    EXPECT_THAT(files[0].text, HasSubstr("<title>Plumb study: A tiny study"));
    for (std::size_t i = 2; i < files.size(); ++i) EXPECT_THAT(files[i].text, StartsWith("<svg xmlns="));
}

TEST(StudyFiles, HoldEveryPointAsARow) {
    const reports::StudyResult result = measured_study();
    const std::vector<std::string> rows = lines(reports::study_csv(result));
    ASSERT_EQ(rows.size(), 1U + 2 * 3 * 3 + 3);
    EXPECT_EQ(rows[0],
              "figure,estimator,integrand,n,evaluations,seconds,mse,mse_low,mse_high,bias,bias_standard_error,"
              "replicates,integral,method");
    const ConvergencePoint& first = result.figures[0].panels[0].series[0].points[0];
    EXPECT_THAT(rows[1], StartsWith("errors,independent,exp,4,4,"));
    EXPECT_THAT(rows[1],
                HasSubstr(fmt::format(",{},{},{},", first.mse, first.mse_interval.low, first.mse_interval.high)));
    EXPECT_THAT(rows.back(), StartsWith("image,independent,exp-sum,16,16,"));
}

TEST(StudyFiles, QuoteNamesThatNeedIt) {
    reports::StudyResult result;
    Series series;
    series.estimator = "a, \"b\"";
    series.points.push_back({.n = 1, .mse = std::nan("")});
    result.figures.push_back({{.id = "f"}, {{"exp", 1, {series}}}});
    EXPECT_THAT(lines(reports::study_csv(result))[1], StartsWith("f,\"a, \"\"b\"\"\",,1,0,0,,-inf,inf,0,0,0,1"));
}

TEST(StudyFiles, StandInTheirFolderTogether) {
    const TestFolder folder;
    reports::write_folder(folder / "study", reports::study_files(measured_study()));
    EXPECT_THAT(read_file(folder / "study" / "series.csv"), StartsWith("figure,estimator"));
}

TEST(MeasureStudy, SaysAllThatAMethodOfScenesIs) {
    const Study study = parse_study(R"(
title = "Parameters"
replicates = 8
n = [4, 16]
[[estimator]]
id = "early roulette"
method = "render"
integrator = "path"
parameters = { roulette-start = 2 }
[[figure]]
id = "floor"
estimators = ["early roulette", "path+sobol"]
integrands = ["quad_light:60,70,4,4"]
)",
                                    "scene.toml");
    reports::StudyResult result;
    result.figures = measure_study(study, plumb::Run(5, "study", 1), [](const auto&) {});
    const auto& methods = result.figures.at(0).panels.at(0).methods;
    EXPECT_EQ(methods.at("early roulette"), "path, independent, roulette-start=2");
    EXPECT_EQ(methods.at("path+sobol"), "path, sobol-owen, roulette-start=5");
    const std::vector<std::string> rows = lines(reports::study_csv(result));
    EXPECT_THAT(rows.front(), EndsWith(",integral,method"));
    EXPECT_THAT(rows.at(1), EndsWith(",\"path, independent, roulette-start=2\""));
}

TEST(MeasureStudy, MeasuresIntegratorsOnScenes) {
    const Study study = parse_study(R"(
title = "A scene"
replicates = 8
n = [4, 16]
[[figure]]
id = "floor"
estimators = ["direct-emitters", "direct-emitters+sobol"]
integrands = ["quad_light:60,70,4,4"]
)",
                                    "scene.toml");
    const std::vector<reports::FigureResult> figures =
        measure_study(study, plumb::Run(5, "study", 1), [](const auto&) {});
    const reports::FigurePanel& panel = figures.at(0).panels.at(0);
    EXPECT_EQ(panel.integrand, "quad_light:60,70,4,4");
    ASSERT_EQ(panel.series.size(), 2u);
    EXPECT_EQ(panel.series[1].estimator, "direct-emitters+sobol");
    ASSERT_EQ(panel.series[1].points.size(), 2u);
    EXPECT_GT(panel.series[0].points[0].evaluations, 4);  // rays
    EXPECT_NEAR(panel.series[0].points[0].bias, 0, 6 * panel.series[0].points[0].bias_standard_error);
    EXPECT_GT(panel.integral, 0);
}

}  // namespace
}  // namespace plumb
