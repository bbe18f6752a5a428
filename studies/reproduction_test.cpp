#include "studies/reproduction.h"

#include <gmock/gmock.h>

#include "core/test_folder.h"
#include "studies/measure.h"
#include "studies/study_file.h"

namespace plumb {
namespace {

using testing::ElementsAre, testing::IsEmpty, testing::SizeIs;

const std::string text = R"(
title = "T"
source = "us"
replicates = 2000
n = [4, 16]
[[figure]]
id = "a"
estimators = ["independent", "stratified"]
integrands = ["exp", "exp-sum"]
[[figure]]
id = "without-headlines"
estimators = ["independent"]
integrands = ["exp"]
[[figure]]
id = "b"
estimators = ["independent"]
integrands = ["exp"]
[[headline]]
place = "p"
states = "s"
figure = "a"
measure = "slope"
estimator = "stratified"
integrand = "exp"
between = [-4, -2]
[[headline]]
place = "p"
states = "s"
figure = "b"
measure = "slope"
estimator = "independent"
at_least = 0
)";

std::vector<FigureTask> tasks(Size size = Size::quick, const std::vector<std::string>& patterns = {}) {
    return figure_tasks({{"one", text}, {"two", text}}, size, patterns);
}

std::vector<std::string> ids(const std::vector<FigureTask>& list) {
    std::vector<std::string> names;
    for (const FigureTask& task : list) names.push_back(task.id);
    return names;
}

const reports::RunInfo run = [] {
    reports::RunInfo info;
    info.seed = 5;
    info.version = "v";
    return info;
}();

/// Measures a shard and returns how many figures that took.
std::size_t measure(const Shard& shard, const std::filesystem::path& store,
                    const std::vector<std::filesystem::path>& others = {}, const reports::RunInfo& as = run) {
    std::vector<std::string> said;
    measure_missing(tasks(), shard, as, store, others, [&](const std::string& what) { said.push_back(what); });
    return said.size();
}

TEST(FigureTasks, AreTheFiguresThatHeadlinesSpeakOf) {
    EXPECT_THAT(ids(tasks()), ElementsAre("one/a", "one/b", "two/a", "two/b"));
    EXPECT_THAT(ids(tasks(Size::quick, {"two"})), ElementsAre("two/a", "two/b"));
    EXPECT_THAT(ids(tasks(Size::quick, {"*/b"})), ElementsAre("one/b", "two/b"));
    EXPECT_THAT(error_of([] { tasks(Size::quick, {"one", "three"}); }), testing::HasSubstr("'three'"));
    EXPECT_EQ(tasks(Size::quick)[0].plan.replicates, 200U);
    EXPECT_EQ(tasks(Size::full)[0].plan.replicates, 2000U);
    EXPECT_NE(tasks(Size::quick)[0].fingerprint, tasks(Size::full)[0].fingerprint);
}

TEST(Reproduction, GoesOnWhereItWas) {
    const TestFolder folder;
    const std::filesystem::path store = folder / "r.db";
    EXPECT_EQ(measure({1, 2}, store), 8U);  // four series of one/a and of two/a
    EXPECT_EQ(measure({1, 1}, store), 2U);
    EXPECT_EQ(measure({1, 1}, store), 0U);
    reports::RunInfo other = run;
    other.seed = 6;
    EXPECT_GT(measure({1, 1}, store, {}, other), 0U);
    EXPECT_EQ(newest_reproduction(store).seed, 6U);
}

TEST(Reproduction, JoinsTheStoresOfShards) {
    const TestFolder folder;
    measure({1, 2}, folder / "1.db");
    measure({2, 2}, folder / "2.db");
    EXPECT_THAT(gather(tasks(), run, {folder / "1.db"}).missing, ElementsAre("one/b", "two/b"));
    const Reproduction joined = gather(tasks(), run, {folder / "1.db", folder / "2.db"});
    EXPECT_THAT(joined.missing, IsEmpty());
    ASSERT_THAT(joined.result.headlines, SizeIs(4));
    EXPECT_EQ(joined.result.headlines[0].outcome, reports::HeadlineOutcome::met);
    EXPECT_EQ(joined.result.headlines[1].outcome, reports::HeadlineOutcome::not_met);
    EXPECT_EQ(joined.result.headlines[3].figure, "two-b");
    EXPECT_EQ(joined.result.figures.at(3).about.id, "two-b");
    measure({1, 1}, folder / "whole.db");
    const Reproduction whole = gather(tasks(), run, {folder / "whole.db"});
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(whole.result.headlines[i].value, joined.result.headlines[i].value);
}

TEST(Reproduction, HasTheNumbersOfItsStudies) {
    const TestFolder folder;
    measure({1, 1}, folder / "r.db");
    FigureTask task = tasks()[0];
    const auto figure = measure_figure(task.study, task.plan, plumb::Run(5, "study", 1), [](const auto&) {});
    const Reproduction whole = gather(tasks(), run, {folder / "r.db"});
    EXPECT_EQ(whole.result.figures[0].panels[1].series[1].points[1].mse, figure.panels[1].series[1].points[1].mse);
    EXPECT_EQ(whole.result.figures[0].panels[1].integral, figure.panels[1].integral);
}

}  // namespace
}  // namespace plumb
