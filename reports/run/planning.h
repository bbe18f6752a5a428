#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/run/results.h"
#include "reports/run/store.h"
#include "verification/runner.h"

namespace plumb::reports {

/// A run that is stored, with what is still to be judged.
struct RunPlan {
    RunInfo run;
    std::int64_t number = 0;  ///< in the store
    std::vector<Item> items = {};
    std::size_t done = 0;  ///< verdicts that are stored already
};

Size size_of(const RunInfo& run);
std::vector<std::string> patterns_of(const RunInfo& run);

/// The newest run of the store (in `file`) that is unfinished and judges claims, or does not (judges_claims()). Throws
/// Error where there is none, or where another version of Plumb began it.
StoredRun newest_unfinished(const Store& store, const std::string& file, bool judging);

/// Begins a run in the store, of the shard of what its patterns select (everything when there is none). The run says
/// seed, alpha, size and shard; the rest is filled in. Throws Error.
RunPlan begin_run(const Catalogue& catalogue, RunInfo run, const std::vector<std::string>& patterns,
                  const std::string& store);

/// The remainder of the newest unfinished run of the store. Throws Error where there is none, or where another version
/// of Plumb or other claims began it.
RunPlan unfinished_run(const Catalogue& catalogue, const std::string& store);

/// The verdicts as a run's results have them.
Results results_of(std::vector<Judged> judged, const Catalogue& catalogue, const RunInfo& run);

}  // namespace plumb::reports
