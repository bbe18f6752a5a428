#include "reports/run/page_series.h"

#include <cmath>

#include "reports/page/series_styles.h"

namespace plumb::reports {
namespace {

using json_values::Json, json_values::number;

Json triple(const Measured& m) {
    return {number(m.value), number(m.low), number(m.high)};
}

Json metrics_of(const ConvergencePoint& point, double truth) {
    Json json = Json::object();
    for (const ErrorMetric& metric : error_metrics()) {
        if (metric.by_truth && std::isnan(truth)) continue;
        const std::string name = metric.name;
        if (!metric.by_cost) json[name] = triple(metric.value(point, truth, point.evaluations));
        if (!metric.by_cost) continue;
        json[name + "/evaluations"] = triple(metric.value(point, truth, point.evaluations));
        json[name + "/seconds"] = triple(metric.value(point, truth, point.seconds));
    }
    return json;
}

}  // namespace

void add_metrics(Json& json, const Series& series, double truth) {
    for (std::size_t i = 0; i < series.points.size(); ++i)
        json["points"][i]["metrics"] = metrics_of(series.points[i], truth);
    const std::optional<bool> meets = meets_expectation(series);
    json["meets_expectation"] = meets ? Json(*meets) : Json(nullptr);
    json["expected_text"] = expected_text(series);
}

Json page_axes() {
    Json works = Json::array(), metrics = Json::array(), symbols = Json::array();
    for (const WorkAxis& axis : work_axes())
        works.push_back({{"name", axis.name}, {"label", axis.label}, {"base", axis.powers_of_two ? 2 : 10}});
    for (const ErrorMetric& metric : error_metrics())
        metrics.push_back({{"name", metric.name},
                           {"label", metric.label},
                           {"exponent", number(metric.exponent)},
                           {"by_cost", metric.by_cost},
                           {"by_truth", metric.by_truth}});
    for (const SeriesSymbol& symbol : series_styles().symbols) symbols.push_back(symbol.name);
    return {{"works", works}, {"metrics", metrics}, {"colours", series_styles().light.size()}, {"symbols", symbols}};
}

}  // namespace plumb::reports
