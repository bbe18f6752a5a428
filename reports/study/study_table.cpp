#include "reports/study/study_table.h"

#include "reports/text/text.h"

namespace plumb::reports {
namespace {

std::vector<std::string> row(const FigureResult& figure, const Series& series) {
    const Slope& slope = series.slope;
    std::vector<std::string> cells = {figure.about.id, series.estimator, series.integrand, "–", "–"};
    if (!series.points.empty()) {
        cells[3] = readable_count(series.points.back().n);
        cells[4] = readable(series.points.back().mse);
    }
    const bool fitted = !std::isnan(slope.value);
    cells.push_back(fitted ? fmt::format("{:.2f}", slope.value) : "–");
    cells.push_back(fitted ? fmt::format("[{:.2f}, {:.2f}]", slope.interval.low, slope.interval.high) : "–");
    cells.push_back(expected_text(series));
    return cells;
}

}  // namespace

std::string study_table(const StudyResult& study, const TableStyle& style) {
    std::vector<std::vector<std::string>> rows;
    for (const FigureResult& figure : study.figures)
        for (const FigurePanel& panel : figure.panels)
            for (const Series& series : panel.series) rows.push_back(row(figure, series));
    const std::vector<Column> columns = {
        {"figure"}, {"estimator"}, {"integrand"}, {"n", Align::right}, {"MSE", Align::right}, {"slope", Align::right},
        {"95 %"},   {"expected"}};
    return table(columns, rows, static_cast<std::size_t>(style.width));
}

}  // namespace plumb::reports
