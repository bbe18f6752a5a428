#include "reports/run/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/error.h"
#include "reports/run/json.h"

namespace plumb::reports {
namespace {

namespace fs = std::filesystem;

struct Setting {
    std::string name, value;
};

// What the shards of one run have in common.
std::vector<Setting> settings_of(const RunInfo& run) {
    return {{"seed", std::to_string(run.seed)},
            {"alpha", fmt::format("{}", run.alpha)},
            {"size", run.size},
            {"patterns", fmt::format("'{}'", run.patterns)},
            {"version", run.version},
            {"number of shards", std::to_string(run.shards)},
            {"claims", fmt::format("of fingerprint {}", run.fingerprint)}};
}

// The first setting in which two runs differ.
std::optional<std::pair<Setting, Setting>> conflict(const RunInfo& a, const RunInfo& b) {
    const std::vector<Setting> of_a = settings_of(a), of_b = settings_of(b);
    for (std::size_t i = 0; i < of_a.size(); ++i)
        if (of_a[i].value != of_b[i].value) return std::pair(of_a[i], of_b[i]);
    return {};
}

std::string name_of(const RunInfo& run) {
    return fmt::format("shard {}/{}", run.shard, run.shards);
}

struct Part {
    fs::path store;
    std::int64_t number;
    Results results;
};

std::string comparable(const Results& results) {
    return to_json(without_side_records(results));
}

// The finished shards in a store that belong to the same run as its newest one; of a shard that was run twice, the
// last.
std::map<int, Part> parts_of(const fs::path& file) {
    const Store store(file, Store::Access::read);
    const std::vector<StoredRun> runs = store.runs();
    if (runs.empty()) throw Error(fmt::format("{}: no run is stored", file.string()));
    std::map<int, Part> parts;
    std::map<int, std::int64_t> unfinished;
    for (const StoredRun& stored : runs) {
        if (conflict(stored.run, runs.back().run)) continue;
        if (stored.run.finished)
            parts.insert_or_assign(stored.run.shard, Part{file, stored.id, store.load(stored.id)});
        else
            unfinished.insert_or_assign(stored.run.shard, stored.id);
    }
    for (const auto& [shard, number] : unfinished)
        if (!parts.contains(shard))
            throw Error(fmt::format("{}: run {}, shard {}/{}, is unfinished; `plumb {} --resume --store {}` goes on",
                                    file.string(), number, shard, runs.back().run.shards, verb_of(runs.back().run),
                                    file.string()));
    return parts;
}

void refuse_conflict(const Part& a, const Part& b) {
    const auto different = conflict(a.results.run, b.results.run);
    if (!different) return;
    throw Error(fmt::format("{} and {} are of different runs: {} {} and {}", a.store.string(), b.store.string(),
                            different->first.name, different->first.value, different->second.value));
}

void refuse_difference(const Part& a, const Part& b) {
    if (comparable(a.results) == comparable(b.results)) return;
    throw Error(
        fmt::format("{} has other results in {} than in {}: one of them was not made by this program, or had a "
                    "time limit",
                    name_of(a.results.run), a.store.string(), b.store.string()));
}

std::map<int, Part> all_parts(const std::vector<fs::path>& stores) {
    std::map<int, Part> all;
    for (const fs::path& file : stores)
        for (auto& [shard, part] : parts_of(file)) {
            if (!all.empty()) refuse_conflict(all.begin()->second, part);
            if (const auto known = all.find(shard); known != all.end()) refuse_difference(known->second, part);
            all.emplace(shard, std::move(part));
        }
    const RunInfo& run = all.begin()->second.results.run;
    std::string missing;
    for (int shard = 1; shard <= run.shards; ++shard)
        if (!all.contains(shard)) missing += fmt::format("{}{}/{}", missing.empty() ? "" : ", ", shard, run.shards);
    if (!missing.empty()) throw Error(fmt::format("the run with seed {} lacks shard {}", run.seed, missing));
    return all;
}

}  // namespace

std::vector<Results> shards_of(const std::vector<fs::path>& stores) {
    std::vector<Results> shards;
    for (std::map<int, Part> parts = all_parts(stores); auto& [shard, part] : parts)
        shards.push_back(std::move(part.results));
    return shards;
}

RunInfo joined_run(const std::vector<Results>& shards) {
    RunInfo run = shards.front().run;
    run.shard = run.shards = 1;
    run.seconds = 0;
    for (const Results& shard : shards) {
        run.started = std::min(run.started, shard.run.started);
        run.seconds += shard.run.seconds;
    }
    return run;
}

Results merge_shards(const std::vector<fs::path>& stores) {
    std::vector<Results> shards = shards_of(stores);
    Results merged{.run = joined_run(shards), .errata = shards.front().errata};
    if (!judges_claims(merged.run))
        throw Error(fmt::format("{}: holds a run of `plumb {}`, which judges no claims", stores.front().string(),
                                verb_of(merged.run)));
    for (Results& shard : shards) {
        std::ranges::move(shard.claims, std::back_inserter(merged.claims));
        std::ranges::move(shard.mutants, std::back_inserter(merged.mutants));
    }
    std::ranges::sort(merged.claims, {}, &ClaimResult::position);
    std::ranges::sort(merged.mutants, {}, &MutantResult::position);
    if (merged.claims.size() + merged.mutants.size() != merged.run.selected)
        throw Error(fmt::format("the shards have {} verdicts together, but {} were selected: a store is damaged",
                                merged.claims.size() + merged.mutants.size(), merged.run.selected));
    return merged;
}

std::int64_t store_once(Store& store, const Results& results) {
    for (const StoredRun& stored : store.runs())
        if (stored.run.finished && stored.run.shards == 1 && !conflict(stored.run, results.run))
            if (comparable(store.load(stored.id)) == comparable(results)) return stored.id;
    return store.append(results);
}

}  // namespace plumb::reports
