#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verification/claim.h"

namespace plumb {

struct RunSetting {
    std::uint64_t seed = 0;
    double alpha = 1e-4;  ///< false-alarm budget of the whole run
    Size size = Size::quick;
    std::vector<std::string> patterns = {};  ///< of claim ids; empty: all
    std::optional<std::chrono::duration<double>> time_limit = {};
    int threads = 1;
};

/// A claim or one of its mutants with its verdict. A mutant that is refuted is killed.
struct Judged {
    const Claim* claim = nullptr;
    const Mutant* mutant = nullptr;  ///< null: the claim itself
    Verdict verdict = {};
    double seconds = 0;

    [[nodiscard]] std::string id() const { return mutant ? claim->id + "/" + mutant->id : claim->id; }
};

/// Told of each verdict as it comes, in any order, one at a time: done of total.
using Progress = std::function<void(const Judged&, std::size_t done, std::size_t total)>;

/// Judges the selected claims of the size class and their mutants; the result stands in catalogue order. A verdict
/// depends on (seed, claim id, alpha, size) alone: not on threads, selection, or what else runs. Throws Error for a
/// pattern that selects nothing.
std::vector<Judged> judge(const Catalogue& catalogue, const RunSetting& setting, const Progress& progress);

}  // namespace plumb
