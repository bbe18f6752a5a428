#include "reports/page_data.h"

#include <nlohmann/json.hpp>

#include "reports/differences.h"
#include "reports/json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json document(const Results& results) {
    Json json = Json::parse(to_json(results));
    json["run"]["seed"] = std::to_string(results.run.seed);
    for (Json& mutant : json["mutants"]) {  // the page draws those of claims only
        mutant.erase("series");
        mutant.erase("stability");
    }
    return json;
}

Json changes(const std::vector<OutcomeChange>& list) {
    Json json = Json::array();
    for (const OutcomeChange& change : list)
        json.push_back({{"id", change.id}, {"before", to_string(change.before)}, {"after", to_string(change.after)}});
    return json;
}

Json differences(const Results& before, const Results& after) {
    const Differences d = diff_runs(before, after);
    return {{"claims", changes(d.claims)}, {"mutants", changes(d.mutants)},    {"added", d.added},
            {"removed", d.removed},        {"added_mutants", d.added_mutants}, {"removed_mutants", d.removed_mutants}};
}

}  // namespace

std::string page_data(const Results& results, const std::optional<Results>& against) {
    Json json = {{"results", document(results)}, {"against", nullptr}};
    if (against)
        json["against"] = {{"run", document(*against)["run"]}, {"differences", differences(*against, results)}};
    std::string text;
    for (const char c : json.dump()) {  // '<' occurs in strings only; so no "</script" or "<!--" can end the element
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

}  // namespace plumb
