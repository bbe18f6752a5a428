#include "reports/study/study_page.h"

#include "reports/page/page_html.h"
#include "reports/run/json_document.h"
#include "reports/run/page_series.h"

namespace plumb::reports {
namespace {

using json_values::Json, json_values::for_script;

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
        json["panels"].push_back({{"integrand", panel.integrand}, {"unit", panel.unit}, {"series", indices}});
    }
    return json;
}

Json headline(const Headline& h) {
    return {{"source", h.source},
            {"place", h.place},
            {"states", h.states},
            {"quoted", h.quoted},
            {"figure", h.figure},
            {"measure", h.measure},
            {"stated", json_values::interval(h.stated)},
            {"stated_text", bound_text(h.stated)},
            {"measured",
             {{"value", json_values::number(h.value)},
              {"low", json_values::number(h.interval.low)},
              {"high", json_values::number(h.interval.high)}}},
            {"logarithmic", h.logarithmic},
            {"outcome", to_string(h.outcome)},
            {"reason", h.reason},
            {"remark", h.remark}};
}

Json headlines(const std::vector<Headline>& list) {
    Json json = Json::array();
    for (const Headline& one : list) json.push_back(headline(one));
    return json;
}

// {"results": the run and all its series, "against": null, "study": texts and figures, which name their series by
// index}.
std::string page_data(const StudyResult& study) {
    Results results{.run = study.run};
    Json figures = Json::array();
    for (const FigureResult& result : study.figures) figures.push_back(figure(result, results.series));
    Json styles = Json::object();
    for (const EstimatorStyle& style : estimator_styles(study)) styles[style.estimator] = style.style;
    Json document = page_document(results);
    std::size_t index = 0;
    for (const FigureResult& result : study.figures)
        for (const FigurePanel& panel : result.panels)
            for (const Series& one : panel.series) add_metrics(document["series"][index++], one, panel.integral);
    return for_script({{"results", document},
                       {"axes", page_axes()},
                       {"against", nullptr},
                       {"study",
                        {{"name", study.about.name},
                         {"title", study.about.title},
                         {"text", study.about.text},
                         {"source", study.about.source},
                         {"several", study.about.several},
                         {"renders", study.about.renders},
                         {"styles", styles},
                         {"figures", figures},
                         {"headline_level", headline_level},
                         {"headlines", headlines(study.headlines)}}}});
}

}  // namespace

std::string headlines_json(const StudyResult& study) {
    return json_values::text_of({{"run", json_document({.run = study.run})["run"]},
                                 {"level", headline_level},
                                 {"headlines", headlines(study.headlines)}},
                                2) +
           "\n";
}

std::string study_html(const StudyResult& study) {
    return page_html((study.about.several || study.about.renders ? "Plumb: " : "Plumb study: ") + study.about.title, page_data(study));
}

}  // namespace plumb::reports
