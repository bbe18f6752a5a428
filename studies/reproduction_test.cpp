#include "studies/reproduction.h"

#include <gmock/gmock.h>

#include "core/test_folder.h"
#include "core/version.h"
#include "reports/run/json.h"
#include "reports/run/merge.h"
#include "reports/run/planning.h"
#include "studies/measure.h"
#include "studies/study_file.h"

namespace plumb {
namespace {

using testing::ElementsAre, testing::HasSubstr, testing::IsEmpty, testing::SizeIs;

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

reports::RunInfo run_of(std::uint64_t seed, const Shard& shard = {}) {
    reports::RunInfo run;
    run.seed = seed;
    run.version = version;
    run.shard = shard.index;
    run.shards = shard.count;
    return run;
}

std::vector<FigureTask> tasks_of(const reports::RunInfo& run) {
    return tasks(reports::size_of(run));
}

std::size_t measure(ReproductionPlan& plan, reports::Store& store) {
    std::vector<std::string> said;
    measure_left(plan, store, {}, [&](const std::string& what) { said.push_back(what); });
    return said.size();
}

/// A whole run in a store of its own.
reports::Results measured(const std::filesystem::path& file, const Shard& shard = {}) {
    reports::Store store(file, reports::Store::Access::append);
    ReproductionPlan plan = begin_reproduction(tasks(), run_of(5, shard), store);
    measure(plan, store);
    return store.load(plan.number);
}

TEST(FigureTasks, AreTheFiguresThatHeadlinesSpeakOf) {
    EXPECT_THAT(ids(tasks()), ElementsAre("one/a", "one/b", "two/a", "two/b"));
    EXPECT_THAT(ids(tasks(Size::quick, {"two"})), ElementsAre("two/a", "two/b"));
    EXPECT_THAT(ids(tasks(Size::quick, {"*/b"})), ElementsAre("one/b", "two/b"));
    EXPECT_THAT(error_of([] { tasks(Size::quick, {"one", "three"}); }), testing::HasSubstr("'three'"));
    EXPECT_EQ(tasks(Size::quick)[0].plan.replicates, 200U);
    EXPECT_EQ(tasks(Size::full)[0].plan.replicates, 2000U);
    EXPECT_EQ(tasks()[1].position, 4U);  // behind the two estimators on two integrands of one/a
}

TEST(Reproduction, GoesOnWhereItWas) {
    const TestFolder folder;
    const std::string file = folder / "r.db";
    reports::Store store(file, reports::Store::Access::append);
    ReproductionPlan begun = begin_reproduction(tasks(), run_of(5), store);
    std::stop_source stop;
    measure_left(begun, store, stop.get_token(), [&](const std::string& what) {
        if (what.starts_with("2/4")) stop.request_stop();  // during one/b, which is dropped
    });
    EXPECT_EQ(begun.done, 1U);
    EXPECT_THAT(gather(begun.tasks, store.load(begun.number)).missing, ElementsAre("one/b", "two/a", "two/b"));
    ReproductionPlan resumed = resume_reproduction(tasks_of, store, file);
    EXPECT_EQ(resumed.done, 1U);
    EXPECT_EQ(measure(resumed, store), 6U);  // series
    EXPECT_EQ(to_json(without_side_records(store.load(1))), to_json(without_side_records(measured(folder / "w.db"))));
    EXPECT_THAT(error_of([&] { resume_reproduction(tasks_of, store, file); }), HasSubstr("nothing to resume"));
}

TEST(Reproduction, IsNotResumedWithOtherStudiesOrAsAnotherRun) {
    const TestFolder folder;
    const std::string file = folder / "r.db";
    reports::Store store(file, reports::Store::Access::append);
    begin_reproduction(tasks(), run_of(5), store);
    const auto fewer = [](const reports::RunInfo&) { return tasks(Size::quick, {"one"}); };
    EXPECT_THAT(error_of([&] { resume_reproduction(fewer, store, file); }), HasSubstr("the studies have changed"));
    EXPECT_THAT(error_of([&] { reports::newest_unfinished(store, file, true); }), HasSubstr("nothing to resume"));
}

TEST(Reproduction, JoinsItsShards) {
    const TestFolder folder;
    const reports::Results first = measured(folder / "1.db", {1, 2});
    measured(folder / "2.db", {2, 2});
    EXPECT_THAT(gather(tasks(), first).missing, ElementsAre("one/b", "two/b"));
    const reports::Results joined = join_figures(tasks_of, reports::shards_of({folder / "2.db", folder / "1.db"}));
    EXPECT_EQ(to_json(without_side_records(joined)), to_json(without_side_records(measured(folder / "w.db"))));
    const Reproduction whole = gather(tasks(), joined);
    EXPECT_THAT(whole.missing, IsEmpty());
    ASSERT_THAT(whole.result.headlines, SizeIs(4));
    EXPECT_EQ(whole.result.headlines[0].outcome, reports::HeadlineOutcome::met);
    EXPECT_EQ(whole.result.headlines[1].outcome, reports::HeadlineOutcome::not_met);
    EXPECT_EQ(whole.result.headlines[3].figure, "two-b");
    EXPECT_EQ(whole.result.figures.at(3).about.id, "two-b");
}

TEST(Reproduction, HasTheNumbersOfItsStudies) {
    const TestFolder folder;
    const FigureTask task = tasks()[0];
    const auto figure = measure_figure(task.study, task.plan, plumb::Run(5, "study", 1), [](const auto&) {});
    const Reproduction whole = gather(tasks(), measured(folder / "r.db"));
    EXPECT_EQ(whole.result.figures[0].panels[1].series[1].points[1].mse, figure.panels[1].series[1].points[1].mse);
    EXPECT_EQ(whole.result.figures[0].panels[1].integral, figure.panels[1].integral);
}

}  // namespace
}  // namespace plumb
