#pragma once

#include <string>
#include <vector>

#include "reports/run/results.h"

namespace plumb::reports {

/// A claim or mutant whose outcome is not the same in two runs.
struct OutcomeChange {
    std::string id;
    Outcome before, after;
};

/// The differences between two runs, as far as their verdicts go.
struct Differences {
    std::vector<OutcomeChange> claims, mutants;  ///< in both runs, with different outcomes
    std::vector<std::string> added, removed;     ///< claims in one of the two runs only
    std::vector<std::string> added_mutants, removed_mutants;
    std::size_t not_asked = 0;  ///< claims and mutants that one of the two runs was not asked for: not compared

    [[nodiscard]] bool empty() const;
};

/// The changes from `before` to `after`, in the order of `after` (removed things in the order of `before`), as far as
/// both runs were asked for: by their patterns, by the same size, and whole, neither a shard nor unfinished.
Differences diff_runs(const Results& before, const Results& after);

}  // namespace plumb::reports
