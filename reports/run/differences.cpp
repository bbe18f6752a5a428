#include "reports/run/differences.h"

#include <map>
#include <string_view>

namespace plumb::reports {
namespace {

template <class Entry>
std::map<std::string_view, Outcome> outcomes(const std::vector<Entry>& entries) {
    std::map<std::string_view, Outcome> by_id;
    for (const Entry& entry : entries) by_id.emplace(entry.id, entry.verdict.outcome);
    return by_id;
}

template <class Entry>
void compare(const std::vector<Entry>& before, const std::vector<Entry>& after, std::vector<OutcomeChange>& changed,
             std::vector<std::string>& added, std::vector<std::string>& removed) {
    const auto earlier = outcomes(before), later = outcomes(after);
    for (const Entry& entry : after) {
        const auto known = earlier.find(entry.id);
        if (known == earlier.end())
            added.push_back(entry.id);
        else if (known->second != entry.verdict.outcome)
            changed.push_back({entry.id, known->second, entry.verdict.outcome});
    }
    for (const Entry& entry : before)
        if (!later.contains(entry.id)) removed.push_back(entry.id);
}

}  // namespace

bool Differences::empty() const {
    return claims.empty() && mutants.empty() && added.empty() && removed.empty() && added_mutants.empty() &&
           removed_mutants.empty();
}

Differences diff_runs(const Results& before, const Results& after) {
    Differences d;
    compare(before.claims, after.claims, d.claims, d.added, d.removed);
    compare(before.mutants, after.mutants, d.mutants, d.added_mutants, d.removed_mutants);
    return d;
}

}  // namespace plumb::reports
