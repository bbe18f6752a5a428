#include "reports/study/study_result.h"

#include "reports/page/series_styles.h"

namespace plumb::reports {
namespace {

const EstimatorStyle* style_of(const std::vector<EstimatorStyle>& styles, std::string_view estimator) {
    const auto at = std::ranges::find(styles, estimator, &EstimatorStyle::estimator);
    return at == styles.end() ? nullptr : &*at;
}

std::vector<std::string> estimators_in(const FigureResult& figure) {
    std::vector<std::string> names;
    for (const FigurePanel& panel : figure.panels)
        for (const Series& series : panel.series)
            if (std::ranges::find(names, series.estimator) == names.end()) names.push_back(series.estimator);
    return names;
}

}  // namespace

std::vector<EstimatorStyle> estimator_styles(const StudyResult& study) {
    const std::size_t colours = series_styles().light.size();
    std::vector<EstimatorStyle> styles;
    for (const FigureResult& figure : study.figures) {
        const std::vector<std::string> names = estimators_in(figure);
        std::vector<bool> seen(colours);
        for (const std::string& name : names)
            if (const EstimatorStyle* style = style_of(styles, name)) seen[style->style % colours] = true;
        for (const std::string& name : names) {
            if (style_of(styles, name)) continue;
            const bool all_seen = std::ranges::all_of(seen, std::identity{});
            std::size_t style = 0;
            while ((!all_seen && seen[style % colours]) ||
                   std::ranges::find(styles, style, &EstimatorStyle::style) != styles.end())
                ++style;
            seen[style % colours] = true;
            styles.push_back({name, style});
        }
    }
    return styles;
}

}  // namespace plumb::reports
