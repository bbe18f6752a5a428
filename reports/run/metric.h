#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "verification/series.h"

// The axes of a figure of error against work: the only place that computes what plots, tables and the page show.
namespace plumb::reports {

/// The quantities of work that an axis of a figure can count.
enum class Work { n, evaluations, seconds };
struct WorkAxis {
    const char *name, *label;
    double (*value)(const ConvergencePoint& point);
    bool powers_of_two = false;  ///< ticks
};
std::span<const WorkAxis> work_axes();  ///< in the order of the enumeration

std::string to_string(Work work);
/// The label of the axis; evaluations go by their unit where a subject has one of its own ("rays" of a scene).
std::string label(Work work, std::string_view unit = {});
/// The axis of this name; throws Error naming the nearest one.
Work work_from(std::string_view name);
double work_of(const ConvergencePoint& point, Work work);

/// A value with its 95 % interval.
struct Measured {
    double value = 0, low = 0, high = 0;
};

/// How wrong an estimator is at a point of a series.
struct ErrorMetric {
    const char *name, *label;
    Measured (*value)(const ConvergencePoint& point, double truth, double cost);
    double exponent =
        std::numeric_limits<double>::quiet_NaN();  ///< where the MSE has 1; NaN where it is no power of it
    bool by_cost = false, by_truth = false;        ///< what `value` needs besides the point
};
/// The table in metric.cpp, the only list of metrics.
std::span<const ErrorMetric> error_metrics();

/// A metric, by its place in the table.
enum class Metric : std::size_t {};
const ErrorMetric& entry(Metric metric);

std::string to_string(Metric metric);
std::string label(Metric metric);
Metric metric_from(std::string_view name);
Measured measured(Metric metric, const ConvergencePoint& point, double integral, Work across);

/// The exponent of this metric where the MSE has exponent `of_mse`; NaN where it is no power of the MSE.
double exponent(Metric metric, double of_mse);

/// Whether the interval of the fitted slope meets what theory expects; empty where nothing is expected or fitted.
std::optional<bool> meets_expectation(const Series& series);
/// The expected slope as text, "−3" or "−4 to −3"; "–" where nothing is expected.
std::string expected_text(const Series& series);

}  // namespace plumb::reports
