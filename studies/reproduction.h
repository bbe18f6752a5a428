#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/shard.h"
#include "reports/run/store.h"
#include "reports/study/study_result.h"
#include "studies/study.h"
#include "verification/run.h"

// What papers promise against what is measured, over all studies that come with Plumb. A reproduction is a run in a
// results store (reports/run/store.h), as `plumb verify` makes: it begins there unfinished, measures one figure of a
// study after the other, is interrupted and resumed, and is cut into shards, which join again.
namespace plumb {

/// A figure that headlines speak of.
struct FigureTask {
    Study study;
    FigurePlan plan;             ///< with the replicates of the size
    std::string id;              ///< STUDY/FIGURE
    std::uint64_t position = 0;  ///< of its first series among all of the run
    std::string text;            ///< what its numbers are a function of, besides the seed

    /// How many series it has.
    [[nodiscard]] std::size_t size() const { return plan.integrands.size() * plan.estimators.size(); }
};

/// The figures of these studies that headlines speak of and whose study or id (STUDY/FIGURE) matches one of the
/// patterns (all when there is none), in order. The quick size has a tenth of the replicates, but 100 where the study
/// has as many; the full one those that the study says. Throws Error for a pattern that selects nothing.
std::vector<FigureTask> figure_tasks(const std::vector<std::pair<std::string, std::string>>& names_and_texts, Size size,
                                     const std::vector<std::string>& patterns);
/// The figure tasks of the studies that come with Plumb.
std::vector<FigureTask> shipped_figure_tasks(Size size, const std::vector<std::string>& patterns);

/// A reproduction in a store, and how many figures of its shard are measured already.
struct ReproductionPlan {
    reports::RunInfo run;
    std::int64_t number = 0;
    std::vector<FigureTask> tasks;  ///< of all shards
    std::size_t done = 0;
};

/// The part of a run's tasks that its shard measures: every n-th.
std::vector<FigureTask> tasks_of_shard(const std::vector<FigureTask>& tasks, const Shard& shard);

/// Begins a run in the store; the run says seed, size, patterns and shard.
ReproductionPlan begin_reproduction(std::vector<FigureTask> tasks, reports::RunInfo run, reports::Store& store);

/// A function that tells what a run with these settings has to measure, and that of the shipped studies.
using TasksOf = std::function<std::vector<FigureTask>(const reports::RunInfo& run)>;
std::vector<FigureTask> shipped_tasks_of(const reports::RunInfo& run);

/// The newest unfinished reproduction of the store (in `file`). Throws Error where there is none, or where another
/// version of Plumb or other studies began it.
ReproductionPlan resume_reproduction(const TasksOf& tasks_of, const reports::Store& store, const std::string& file);

/// Measures what is left of the plan, stores each figure as soon as it is measured, and marks the run as finished
/// unless it was stopped. `progress` is told what comes next. The random numbers are those of `plumb study`.
void measure_left(ReproductionPlan& plan, reports::Store& store, const std::stop_token& stop,
                  const std::function<void(const std::string& what)>& progress);

/// The run that shards (reports/run/merge.h) make up. Throws Error where they measured other figures than these.
reports::Results join_figures(const TasksOf& tasks_of, const std::vector<reports::Results>& shards);

/// What a stored run says of these tasks, as one study: figures under the ids STUDY-FIGURE, headlines in the order of
/// the files. `missing` are the tasks that it has not measured.
struct Reproduction {
    reports::StudyResult result;
    std::vector<std::string> missing;
};
Reproduction gather(const std::vector<FigureTask>& tasks, const reports::Results& stored);

}  // namespace plumb
