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

    [[nodiscard]] bool empty() const;
};

/// The changes from `before` to `after`, in the order of `after` (removed things in the order of `before`).
Differences diff_runs(const Results& before, const Results& after);

}  // namespace plumb::reports
