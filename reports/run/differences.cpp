#include "reports/run/differences.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "reports/run/planning.h"
#include "verification/claim.h"

namespace plumb::reports {
namespace {

template <class Entry>
std::map<std::string_view, Outcome> outcomes(const std::vector<Entry>& entries) {
    std::map<std::string_view, Outcome> by_id;
    for (const Entry& entry : entries) by_id.emplace(entry.id, entry.verdict.outcome);
    return by_id;
}

const std::string& claim_of(const ClaimResult& claim) {
    return claim.id;
}
const std::string& claim_of(const MutantResult& mutant) {
    return mutant.of;
}

// Whether a run that lacks this lacks it although it was asked for.
template <class Entry>
bool asked_for(const Entry& entry, const RunInfo& by, const RunInfo& other) {
    if (by.shards > 1 || !by.finished || by.size != other.size) return false;
    const std::vector<std::string> patterns = patterns_of(by);
    return patterns.empty() ||
           std::ranges::any_of(patterns, [&](const std::string& p) { return matches(claim_of(entry), p); });
}

struct Lists {
    std::vector<OutcomeChange>& changed;
    std::vector<std::string>&added, &removed;
    std::size_t& not_asked;
};

template <class Entry>
void compare(const std::vector<Entry>& before, const std::vector<Entry>& after, const RunInfo& run_before,
             const RunInfo& run_after, const Lists& lists) {
    const auto earlier = outcomes(before), later = outcomes(after);
    const auto missing = [&](const Entry& entry, const RunInfo& in, const RunInfo& other,
                             std::vector<std::string>& list) {
        if (asked_for(entry, in, other))
            list.push_back(entry.id);
        else
            ++lists.not_asked;
    };
    for (const Entry& entry : after) {
        const auto known = earlier.find(entry.id);
        if (known == earlier.end())
            missing(entry, run_before, run_after, lists.added);
        else if (known->second != entry.verdict.outcome)
            lists.changed.push_back({entry.id, known->second, entry.verdict.outcome});
    }
    for (const Entry& entry : before)
        if (!later.contains(entry.id)) missing(entry, run_after, run_before, lists.removed);
}

}  // namespace

bool Differences::empty() const {
    return claims.empty() && mutants.empty() && added.empty() && removed.empty() && added_mutants.empty() &&
           removed_mutants.empty();
}

Differences diff_runs(const Results& before, const Results& after) {
    Differences d;
    compare(before.claims, after.claims, before.run, after.run, {d.claims, d.added, d.removed, d.not_asked});
    compare(before.mutants, after.mutants, before.run, after.run,
            {d.mutants, d.added_mutants, d.removed_mutants, d.not_asked});
    return d;
}

}  // namespace plumb::reports
