#include "reports/page_data.h"

#include <nlohmann/json.hpp>

#include "reports/differences.h"
#include "reports/json.h"
#include "reports/json_values.h"

namespace plumb {
namespace {

using json_values::Json, json_values::for_script;

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

Json figure(const FigureResult& result, std::vector<Series>& series) {
    const FigureText& about = result.about;
    Json json = {{"id", about.id},           {"title", about.title},
                 {"text", about.text},       {"source_says", about.source_says},
                 {"x", to_string(about.x)},  {"x_label", about.x_label},
                 {"metrics", Json::array()}, {"slopes", about.slopes},
                 {"panels", Json::array()}};
    for (const Metric metric : about.metrics) json["metrics"].push_back(to_string(metric));
    for (const FigurePanel& panel : result.panels) {
        Json indices = Json::array();
        for (const Series& one : panel.series) {
            indices.push_back(series.size());
            series.push_back(one);
        }
        json["panels"].push_back({{"integrand", panel.integrand}, {"integral", panel.integral}, {"series", indices}});
    }
    return json;
}

}  // namespace

std::string page_data(const Results& results, const std::optional<Results>& against) {
    Json json = {{"results", document(results)}, {"against", nullptr}};
    if (against)
        json["against"] = {{"run", document(*against)["run"]}, {"differences", differences(*against, results)}};
    return for_script(json);
}

std::string page_data(const StudyResult& study) {
    Results results{.run = study.run};
    Json figures = Json::array();
    for (const FigureResult& result : study.figures) figures.push_back(figure(result, results.series));
    Json styles = Json::object();
    for (const EstimatorStyle& style : estimator_styles(study)) styles[style.estimator] = style.style;
    return for_script({{"results", document(results)},
                       {"against", nullptr},
                       {"study",
                        {{"name", study.about.name},
                         {"title", study.about.title},
                         {"text", study.about.text},
                         {"source", study.about.source},
                         {"styles", styles},
                         {"figures", figures}}}});
}

}  // namespace plumb
