#include "reports/run/metric.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/named.h"
#include "reports/text/text.h"

namespace plumb::reports {
namespace {

constexpr std::array<WorkAxis, 3> works = {{
    {"n", "samples n", [](const ConvergencePoint& p) { return static_cast<double>(p.n); }, true},
    {"evaluations", "evaluations", [](const ConvergencePoint& p) { return p.evaluations; }},
    {"seconds", "seconds per estimate", [](const ConvergencePoint& p) { return p.seconds; }},
}};

Measured mse(const ConvergencePoint& p, double, double) {
    return {p.mse, p.mse_interval.low, p.mse_interval.high};
}

Measured rmse(const ConvergencePoint& p, double, double) {
    const auto root = [](double x) { return std::sqrt(std::max(x, 0.0)); };
    return {root(p.mse), root(p.mse_interval.low), root(p.mse_interval.high)};
}

// MSE / I².
Measured relative_mse(const ConvergencePoint& p, double truth, double) {
    const double square = truth * truth;
    return {p.mse / square, p.mse_interval.low / square, p.mse_interval.high / square};
}

// Its absolute value.
Measured bias(const ConvergencePoint& p, double, double) {
    const double half = 1.959963984540054 * p.bias_standard_error, size = std::abs(p.bias);
    return {size, size - half, size + half};
}

// 1 / (MSE × cost), the cost in evaluations, or in seconds when they are the axis. The interval turns round; a low
// bound of the MSE at or below 0 leaves no high one.
Measured efficiency(const ConvergencePoint& p, double, double cost) {
    const auto inverse = [&](double x) { return x > 0 ? 1 / (x * cost) : std::numeric_limits<double>::infinity(); };
    return {1 / (p.mse * cost), 1 / (p.mse_interval.high * cost), inverse(p.mse_interval.low)};
}

constexpr ErrorMetric metrics[] = {
    {"mse", "MSE", mse, 1},
    {"rmse", "RMSE", rmse, 0.5},
    {"relative_mse", "relative MSE", relative_mse, 1, false, true},
    {"bias", "|bias|", bias},
    {.name = "efficiency", .label = "efficiency 1 / (MSE × cost)", .value = efficiency, .by_cost = true},
};

/// The value of an enumeration whose names stand in the list, in its order.
template <class Value, class List>
Value value_from(const List& list, std::string_view what, std::string_view name) {
    const auto& entry = find_named(list, name, what, [](const auto& e) { return std::string_view(e.name); });
    return static_cast<Value>(&entry - std::data(list));
}

const WorkAxis& axis(Work work) {
    return works.at(static_cast<std::size_t>(work));
}

}  // namespace

std::span<const WorkAxis> work_axes() {
    return works;
}
std::string to_string(Work work) {
    return axis(work).name;
}
std::string label(Work work, std::string_view unit) {
    return work == Work::evaluations && !unit.empty() ? std::string(unit) : axis(work).label;
}
Work work_from(std::string_view name) {
    return value_from<Work>(works, "axis", name);
}
double work_of(const ConvergencePoint& point, Work work) {
    return axis(work).value(point);
}

std::span<const ErrorMetric> error_metrics() {
    return metrics;
}
const ErrorMetric& entry(Metric metric) {
    return metrics[static_cast<std::size_t>(metric)];
}
std::string to_string(Metric metric) {
    return entry(metric).name;
}
std::string label(Metric metric) {
    return entry(metric).label;
}
Metric metric_from(std::string_view name) {
    return value_from<Metric>(metrics, "metric", name);
}

Measured measured(Metric metric, const ConvergencePoint& point, double integral, Work across) {
    return entry(metric).value(point, integral, across == Work::seconds ? point.seconds : point.evaluations);
}

double exponent(Metric metric, double of_mse) {
    return entry(metric).exponent * of_mse;
}

std::optional<bool> meets_expectation(const Series& series) {
    if (!series.expected_slope || std::isnan(series.slope.value) || !series.slope.doubt.empty()) return {};
    return !series.slope.interval.disjoint(*series.expected_slope);
}

std::string expected_text(const Series& series) {
    if (!series.expected_slope) return "–";
    const auto& [low, high] = *series.expected_slope;
    return low == high ? readable(low) : fmt::format("{} to {}", readable(low), readable(high));
}

}  // namespace plumb::reports
