#pragma once

#include <string>
#include <string_view>

#include "verification/series.h"

// The axes of a figure of error against work.
namespace plumb::reports {

enum class Work { n, evaluations, seconds };
std::string to_string(Work work);
std::string label(Work work);
/// Throws Error naming the nearest one.
Work work_from(std::string_view name);
double work_of(const ConvergencePoint& point, Work work);

enum class Metric {
    mse,
    rmse,
    relative_mse,  ///< MSE / I²
    bias,          ///< its absolute value
    efficiency,    ///< 1 / (MSE × cost), the cost in evaluations, or in seconds when they are the axis
};
std::string to_string(Metric metric);
std::string label(Metric metric);
Metric metric_from(std::string_view name);

/// A value with its 95 % interval.
struct Measured {
    double value = 0, low = 0, high = 0;
};
Measured measured(Metric metric, const ConvergencePoint& point, double integral, Work across);

/// The exponent of this metric where the MSE has exponent `of_mse`; NaN where it is no power of the MSE.
double exponent(Metric metric, double of_mse);

}  // namespace plumb::reports
