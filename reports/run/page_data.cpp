#include "reports/run/page_data.h"

#include "reports/run/differences.h"
#include "reports/run/json_document.h"
#include "reports/run/page_series.h"

namespace plumb::reports {
namespace {

using json_values::Json, json_values::for_script;

Json changes(const std::vector<OutcomeChange>& list) {
    Json json = Json::array();
    for (const OutcomeChange& change : list)
        json.push_back({{"id", change.id}, {"before", to_string(change.before)}, {"after", to_string(change.after)}});
    return json;
}

Json differences(const Results& before, const Results& after) {
    const Differences d = diff_runs(before, after);
    return {{"claims", changes(d.claims)}, {"mutants", changes(d.mutants)},    {"added", d.added},
            {"removed", d.removed},        {"added_mutants", d.added_mutants}, {"removed_mutants", d.removed_mutants},
            {"not_asked", d.not_asked}};
}

}  // namespace

Json page_document(const Results& results) {
    Json json = json_document(results);
    for (std::size_t i = 0; i < results.claims.size(); ++i)
        for (std::size_t j = 0; j < results.claims[i].verdict.series.size(); ++j)
            add_metrics(json["claims"][i]["series"][j], results.claims[i].verdict.series[j]);
    for (std::size_t i = 0; i < results.series.size(); ++i) add_metrics(json["series"][i], results.series[i]);
    json["run"]["seed"] = std::to_string(results.run.seed);
    for (Json& mutant : json["mutants"]) {  // the page draws those of claims only
        mutant.erase("series");
        mutant.erase("stability");
    }
    return json;
}

std::string page_data(const Results& results, const std::optional<Results>& against) {
    Json json = {{"results", page_document(results)}, {"against", nullptr}, {"axes", page_axes()}};
    if (against)
        json["against"] = {{"run", page_document(*against)["run"]}, {"differences", differences(*against, results)}};
    return for_script(json);
}

}  // namespace plumb::reports
