#pragma once

#include <filesystem>
#include <vector>

#include "reports/run/results.h"
#include "reports/run/store.h"

namespace plumb::reports {

/// The run whose shards these stores hold, as one run without shards would have given it but for the side records
/// (`started` of the first shard, the sum of the seconds). Of each store the newest run counts, with the other shards
/// of the same run that the store has. Throws Error for a shard that is missing or unfinished, for stores of different
/// runs, and for two results of one shard that differ.
Results merge_shards(const std::vector<std::filesystem::path>& stores);

/// The number of this run in the store, where it is added unless it is there already.
std::int64_t store_once(Store& store, const Results& results);

}  // namespace plumb::reports
