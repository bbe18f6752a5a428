#pragma once

#include <filesystem>
#include <vector>

#include "reports/run/results.h"
#include "reports/run/store.h"

namespace plumb::reports {

/// The shards of the run that these stores hold, each once, from the first to the last. Of each store the newest run
/// counts, with the other shards of the same run that the store has. Throws Error for a shard that is missing or
/// unfinished, for stores of different runs, and for two results of one shard that differ.
std::vector<Results> shards_of(const std::vector<std::filesystem::path>& stores);

/// The run that these shards make up, without their results: not a part of anything, `started` is that of the first
/// shard to start, `seconds` the sum.
RunInfo joined_run(const std::vector<Results>& shards);

/// The run whose shards these stores hold, as one run without shards would have given it but for the side records.
/// Throws Error as shards_of(), and for a run that judged no claims.
Results merge_shards(const std::vector<std::filesystem::path>& stores);

/// The number of this run in the store, where it is added unless it is there already.
std::int64_t store_once(Store& store, const Results& results);

}  // namespace plumb::reports
