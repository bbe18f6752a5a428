#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/shard.h"
#include "verification/claim.h"

namespace plumb {

/// The setting of a run of the catalogue.
struct RunSetting {
    std::uint64_t seed = 0;
    double alpha = 1e-4;  ///< false-alarm budget of the whole run
    Size size = Size::quick;
    std::vector<std::string> patterns = {};                        ///< of claim ids; empty: all
    std::optional<std::chrono::duration<double>> time_limit = {};  ///< what is open then is undecided
    std::stop_token stop = {};                                     ///< what is open when a stop is asked for is dropped
    int threads = 1;
};

/// A claim or one of its mutants, waiting for a verdict.
struct Item {
    const Claim* claim = nullptr;
    const Mutant* mutant = nullptr;  ///< null: the claim itself
    std::size_t position = 0;        ///< among all that was selected, in catalogue order

    [[nodiscard]] std::string id() const { return mutant ? claim->id + "/" + mutant->id : claim->id; }
};

/// A claim or mutant with its verdict. A mutant that is refuted is killed.
struct Judged : Item {
    Verdict verdict = {};
    double seconds = 0;
};

/// A listener that is told of each verdict as it comes, in any order, one at a time: done of total.
using Progress = std::function<void(const Judged&, std::size_t done, std::size_t total)>;

/// The claims of the size class that match one of the patterns (all when there is none), each followed by its mutants,
/// in catalogue order. Throws Error for a pattern that selects nothing.
std::vector<Item> select(const Catalogue& catalogue, Size size, const std::vector<std::string>& patterns);

/// The shard's items, every n-th claim and every n-th mutant: neighbours, which tend to cost the same, go to different
/// shards.
std::vector<Item> shard_of(std::vector<Item> items, Shard shard);

/// Judges what the setting selects, or just these items of it; the result is in the order of the catalogue. A verdict
/// depends on (seed, claim id, alpha, size) alone: not on threads, selection, or what else runs. After a stop the
/// result has only what was judged before.
std::vector<Judged> judge(const Catalogue& catalogue, const RunSetting& setting, const Progress& progress);
std::vector<Judged> judge(const Catalogue& catalogue, std::span<const Item> items, const RunSetting& setting,
                          const Progress& progress);

}  // namespace plumb
