#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/run/metric.h"
#include "reports/run/results.h"
#include "reports/study/headline.h"

namespace plumb::reports {

/// The text of a study's figure: what it shows and how, as the study's file states it (docs/studies.md).
struct FigureText {
    std::string id = {};                ///< lower-case letters, digits and hyphens: part of file names
    std::string title = {}, text = {};  ///< what is shown and what to look at
    std::string source_says = {};       ///< what the source states about it, for the reader to compare; or empty
    Work x = Work::n;
    std::string x_label = {};  ///< in place of the axis' own, where n stands for something else; or empty
    std::vector<Metric> metrics = {metric_from("mse")};
    std::vector<double> slopes = {};  ///< exponents of the MSE to draw as guides
};

/// One plot for each integrand and metric.
struct FigurePanel {
    std::string integrand;
    double integral = 0;
    std::vector<Series> series;                         ///< one for each estimator
    std::string unit = "evaluations of the integrand";  ///< what Work::evaluations counts
    std::map<std::string, std::string> methods = {};    ///< of a scene: what each estimator is, with its parameters
};

/// A figure with its panels, measured.
struct FigureResult {
    FigureText about;
    std::vector<FigurePanel> panels;
};

/// The text of a study: what it is called, what it asks and where that comes from.
struct StudyText {
    std::string name, title, text, source;
    bool several = false;  ///< figures of several studies, whose titles begin with the study's and a colon
    bool renders = false;  ///< no study: series of pictures that somebody has, against a reference
};

/// Everything that a study found: the one value that its page, CSV and plots render.
struct StudyResult {
    RunInfo run;
    StudyText about;
    std::vector<FigureResult> figures;
    std::vector<Headline> headlines = {};
};

/// The style of an estimator, which gives it one colour and symbol in all figures of a study: a number that no other
/// estimator has, and, while the colours suffice, a colour (the number modulo theirs) that no other has in the same
/// figure.
struct EstimatorStyle {
    std::string estimator;
    std::size_t style = 0;
};
std::vector<EstimatorStyle> estimator_styles(const StudyResult& study);

}  // namespace plumb::reports
