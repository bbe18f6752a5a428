#include "reports/study/study_files.h"

#include <iterator>

#include "reports/study/csv.h"
#include "reports/study/study_page.h"
#include "reports/study/svg_plot.h"

namespace plumb::reports {
namespace {

SvgPlot plot_of(const FigureText& about, const FigurePanel& panel, Metric metric,
                const std::vector<EstimatorStyle>& styles) {
    SvgPlot plot{.title = about.title,
                 .subtitle = panel.integrand,
                 .x_label = about.x == Work::n && !about.x_label.empty() ? about.x_label : label(about.x, panel.unit),
                 .y_label = label(metric),
                 .powers_of_two = about.x == Work::n,
                 .lines = {},
                 .slopes = {}};
    for (const double slope : about.x == Work::seconds ? std::vector<double>{} : about.slopes)
        if (const double shown = exponent(metric, slope); !std::isnan(shown)) plot.slopes.push_back(shown);
    for (const Series& series : panel.series) {
        const auto style = std::ranges::find(styles, series.estimator, &EstimatorStyle::estimator);
        SvgLine& line = plot.lines.emplace_back(SvgLine{series.estimator, style->style, {}});
        for (const ConvergencePoint& point : series.points) {
            const Measured y = measured(metric, point, panel.integral, about.x);
            line.points.push_back({work_of(point, about.x), y.value, y.low, y.high});
        }
    }
    return plot;
}

/// The figure's id, with the integrand and the metric where there are several.
std::string svg_name(const FigureResult& figure, const FigurePanel& panel, Metric metric) {
    std::string name = figure.about.id;
    if (figure.panels.size() > 1) name += "-" + panel.integrand;
    if (figure.about.metrics.size() > 1) name += "-" + to_string(metric);
    std::ranges::replace(name, '/', '-');
    return name + ".svg";
}

/// What the estimator of a scene is; empty for estimators of integrands, whose names say all.
std::string method_of(const FigurePanel& panel, const Series& series) {
    const auto found = panel.methods.find(series.estimator);
    return found == panel.methods.end() ? "" : found->second;
}

}  // namespace

std::string study_csv(const StudyResult& study) {
    std::string csv =
        "figure,estimator,integrand,n,evaluations,seconds,mse,mse_low,mse_high,bias,bias_standard_error,replicates,"
        "integral,method\r\n";
    for (const FigureResult& figure : study.figures)
        for (const FigurePanel& panel : figure.panels)
            for (const Series& series : panel.series)
                for (const ConvergencePoint& p : series.points)
                    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n",
                                   csv_cell(figure.about.id), csv_cell(series.estimator), csv_cell(series.integrand),
                                   p.n, csv_cell(p.evaluations), csv_cell(p.seconds), csv_cell(p.mse),
                                   csv_cell(p.mse_interval.low), csv_cell(p.mse_interval.high), csv_cell(p.bias),
                                   csv_cell(p.bias_standard_error), series.replicates, csv_cell(panel.integral),
                                   csv_cell(method_of(panel, series)));
    return csv;
}

std::vector<FolderFile> study_files(const StudyResult& study) {
    std::vector<FolderFile> files = {{"index.html", study_html(study)}, {"series.csv", study_csv(study)}};
    if (!study.headlines.empty()) {
        files.push_back({"headlines.csv", headline_csv(study.headlines)});
        files.push_back({"headlines.json", headlines_json(study)});
    }
    const std::vector<EstimatorStyle> styles = estimator_styles(study);
    for (const FigureResult& figure : study.figures)
        for (const FigurePanel& panel : figure.panels)
            for (const Metric metric : figure.about.metrics)
                files.push_back(
                    {svg_name(figure, panel, metric), to_svg(plot_of(figure.about, panel, metric, styles))});
    return files;
}

}  // namespace plumb::reports
