#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/interval.h"
#include "reports/study/headline.h"
#include "reports/study/study_result.h"

namespace plumb {

struct Study;

/// A statement of a source, and how it is measured on a figure of the study (docs/studies.md).
struct HeadlinePlan {
    std::string source, place, states, remark;
    bool quoted = false;                        ///< states: in the source's own words
    std::string not_comparable;                 ///< why nothing here can decide it; then what follows is empty
    std::string figure;                         ///< id of the figure whose series are used
    std::string measure;                        ///< a name of headline_measures()
    std::string estimator, against, integrand;  ///< against: of a difference of slopes or a ratio; or empty
    std::uint64_t from = 0, to = 0;             ///< counts of the figure's budget; equal where one is meant
    bool in_evaluations = false;                ///< what these count; else samples
    Interval stated;
};

/// The names of what can be measured: "slope" (of log MSE on log n) and "relative_mse" (MSE / I²), which are set
/// against those of another estimator by their difference; "relative_bias" (|bias / I|); and positive numbers, which
/// are by their ratio: "mse", "rmse", "efficiency" (per evaluation), "seconds" (which are shown and decide nothing).
std::vector<std::string> headline_measures();

/// Whether the measure looks at several counts, and whether it can be set against another estimator.
bool measures_a_range(std::string_view measure);
bool measures_against(std::string_view measure);

/// The statement beside what the figure, measured, says of it.
reports::Headline measure_headline(const HeadlinePlan& plan, const reports::FigureResult& figure);

/// Every statement of a study in the order of its file, from its figures as measured; one whose figure is not among
/// them is left out.
std::vector<reports::Headline> measure_headlines(const Study& study, const std::vector<reports::FigureResult>& figures);

}  // namespace plumb
