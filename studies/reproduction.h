#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "reports/study/study_result.h"
#include "studies/study.h"
#include "verification/run.h"
#include "verification/runner.h"

// What papers promise against what is measured, over all studies that come with Plumb. The unit of work is a figure of
// a study: measured figures are kept in a results store (reports/run/store.h), a run each, so that an interrupted
// reproduction goes on where it was and the parts of several machines join.
namespace plumb {

/// A figure that headlines speak of.
struct FigureTask {
    Study study;
    FigurePlan plan;          ///< with the replicates of the size
    std::string id;           ///< STUDY/FIGURE
    std::string fingerprint;  ///< of the study's text, the figure and the replicates
};

/// The figures of these studies that headlines speak of and whose study or id (STUDY/FIGURE) matches one of the
/// patterns (all when there is none), in order. The quick size has a tenth of the replicates, but 100 where the study
/// has as many; the full one those that the study says. Throws Error for a pattern that selects nothing.
std::vector<FigureTask> figure_tasks(const std::vector<std::pair<std::string, std::string>>& names_and_texts, Size size,
                                     const std::vector<std::string>& patterns);
/// Of the studies that come with Plumb.
std::vector<FigureTask> shipped_figure_tasks(Size size, const std::vector<std::string>& patterns);

/// Measures the shard's part of what no store has yet for this seed, size and version, and adds it to the store as it
/// comes. The random numbers are those of `plumb study`.
void measure_missing(const std::vector<FigureTask>& tasks, const Shard& shard, const reports::RunInfo& run,
                     const std::filesystem::path& store, const std::vector<std::filesystem::path>& others,
                     const std::function<void(const std::string& what)>& progress);

/// What the stores have of these tasks, as one study: figures under the ids STUDY-FIGURE, headlines in the order of the
/// files. `missing` are the tasks that no store has.
struct Reproduction {
    reports::StudyResult result;
    std::vector<std::string> missing;
};
Reproduction gather(const std::vector<FigureTask>& tasks, const reports::RunInfo& run,
                    const std::vector<std::filesystem::path>& stores);

/// Seed and size of the newest reproduction in a store; throws Error where it has none.
reports::RunInfo newest_reproduction(const std::filesystem::path& store);

}  // namespace plumb
