#include "reports/run/merge.h"

#include <gmock/gmock.h>

#include "core/test_folder.h"
#include "reports/run/json.h"
#include "reports/run/sample_results.h"

namespace plumb::reports {
namespace {

using testing::AllOf, testing::HasSubstr, testing::SizeIs;
namespace fs = std::filesystem;

// The index-th of three shards of sample_results().
Results shard(int index) {
    const Results whole = sample_results();
    Results part{.run = whole.run, .errata = whole.errata};
    part.run.shard = index;
    part.run.shards = 3;
    part.run.seconds = 2.0 * index;
    part.run.started = "2025-01-3" + std::to_string(index % 2) + "T00:00:00Z";
    for (const ClaimResult& claim : whole.claims)
        if (claim.position % 3 + 1 == static_cast<unsigned>(index)) part.claims.push_back(claim);
    for (const MutantResult& mutant : whole.mutants)
        if (mutant.position % 3 + 1 == static_cast<unsigned>(index)) part.mutants.push_back(mutant);
    return part;
}

fs::path stored(const TestFolder& folder, const std::string& name, const std::vector<Results>& runs) {
    Store store(folder / name, Store::Access::append);
    for (const Results& run : runs) store.append(run);
    return folder / name;
}

std::vector<fs::path> three(const TestFolder& folder) {
    return {stored(folder, "b.db", {shard(2)}), stored(folder, "a.db", {shard(1)}), stored(folder, "c.db", {shard(3)})};
}

TEST(Merge, GivesTheRunWithoutShards) {
    const TestFolder folder;
    const Results merged = merge_shards(three(folder));
    Results whole = sample_results();
    whole.series.clear();  // they belong to no claim: shards have none
    EXPECT_EQ(to_json(without_side_records(merged)), to_json(without_side_records(whole)));
    EXPECT_EQ(merged.run.seconds, 12);
    EXPECT_EQ(merged.run.started, "2025-01-30T00:00:00Z");
    EXPECT_EQ(merged.claims.back().position, whole.claims.back().position);
}

TEST(Merge, TwiceOrWithAShardRunAgainChangesNothing) {
    const TestFolder folder;
    std::vector<fs::path> stores = three(folder);
    Store out(folder / "out.db", Store::Access::append);
    EXPECT_EQ(store_once(out, merge_shards(stores)), 1);
    stores.push_back(stored(folder, "again.db", {earlier_sample_results(), shard(2), shard(2)}));
    stores.push_back(stored(folder, "a.db", {shard(1)}));
    EXPECT_EQ(store_once(out, merge_shards(stores)), 1);
    EXPECT_THAT(out.runs(), SizeIs(1));
}

TEST(Merge, TakesAllShardsFromOneStore) {
    const TestFolder folder;
    const fs::path all = stored(folder, "all.db", {shard(3), earlier_sample_results(), shard(1), shard(2)});
    EXPECT_THAT(merge_shards({all}).claims, SizeIs(sample_results().claims.size()));
}

TEST(Merge, NamesWhatIsMissingOrUnfinished) {
    const TestFolder folder;
    const std::vector<fs::path> stores = three(folder);
    EXPECT_THAT(error_of([&] { merge_shards({stores[0]}); }), HasSubstr("shard 1/3, 3/3"));
    Store(folder / "open.db", Store::Access::append).begin(shard(2).run, {});
    EXPECT_THAT(error_of([&] {
                    merge_shards({stores[1], folder / "open.db"});
                }),
                HasSubstr("open.db: run 1, shard 2/3, is unfinished"));
    Store(folder / "empty.db", Store::Access::append);
    EXPECT_THAT(error_of([&] { merge_shards({folder / "empty.db"}); }), HasSubstr("empty.db: no run is stored"));
    EXPECT_THAT(error_of([&] { merge_shards({folder / "none.db"}); }), HasSubstr("there is no such results store"));
}

TEST(Merge, RefusesShardsOfDifferentRunsNamingBoth) {
    const TestFolder folder;
    const fs::path a = stored(folder, "a.db", {shard(1)});
    const auto refusal = [&](const std::string& name, void (*change)(RunInfo&)) {
        Results other = shard(2);
        change(other.run);
        return error_of([&] { merge_shards({a, stored(folder, name, {other})}); });
    };
    EXPECT_THAT(
        refusal("seed.db", [](RunInfo& run) { run.seed = 8; }),
        AllOf(HasSubstr("a.db and "), HasSubstr("seed.db are of different runs: seed 17592186044416123457 and 8")));
    EXPECT_THAT(refusal("alpha.db", [](RunInfo& run) { run.alpha = 0.01; }), HasSubstr("alpha 0.0001 and 0.01"));
    EXPECT_THAT(refusal("size.db", [](RunInfo& run) { run.size = "full"; }), HasSubstr("size quick and full"));
    EXPECT_THAT(refusal("patterns.db", [](RunInfo& run) { run.patterns = "x"; }), HasSubstr("patterns '' and 'x'"));
    EXPECT_THAT(refusal("version.db", [](RunInfo& run) { run.version = "9"; }), HasSubstr("version 0.1.0 and 9"));
    EXPECT_THAT(refusal("shards.db", [](RunInfo& run) { run.shards = 4; }), HasSubstr("number of shards 3 and 4"));
    EXPECT_THAT(refusal("claims.db", [](RunInfo& run) { run.fingerprint = "f"; }), HasSubstr("claims of fingerprint"));
}

TEST(Merge, RefusesTwoResultsOfOneShardThatDiffer) {
    const TestFolder folder;
    std::vector<fs::path> stores = three(folder);
    Results other = shard(2);
    other.claims[0].verdict.samples += 1;
    stores.push_back(stored(folder, "other.db", {other}));
    EXPECT_THAT(error_of([&] { merge_shards(stores); }), HasSubstr("shard 2/3 has other results in "));
}

}  // namespace
}  // namespace plumb::reports
