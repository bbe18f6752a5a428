#include "reports/study/metric.h"

#include "core/error.h"

namespace plumb::reports {
namespace {

struct Named {
    const char *name, *label;
};
constexpr std::array<Named, 3> works = {
    {{"n", "samples n"}, {"evaluations", "evaluations of the integrand"}, {"seconds", "seconds per estimate"}}};
constexpr std::array<Named, 5> metrics = {{{"mse", "MSE"},
                                           {"rmse", "RMSE"},
                                           {"relative_mse", "relative MSE"},
                                           {"bias", "|bias|"},
                                           {"efficiency", "efficiency 1 / (MSE × cost)"}}};

template <class Value, std::size_t N>
Value value_from(const std::array<Named, N>& list, std::string_view what, std::string_view name) {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < N; ++i) {
        if (name == list[i].name) return static_cast<Value>(i);
        known.emplace_back(list[i].name);
    }
    throw unknown_name(what, name, known);
}

double root(double x) {
    return std::sqrt(std::max(x, 0.0));
}

}  // namespace

std::string to_string(Work work) {
    return works.at(static_cast<std::size_t>(work)).name;
}
std::string label(Work work) {
    return works.at(static_cast<std::size_t>(work)).label;
}
Work work_from(std::string_view name) {
    return value_from<Work>(works, "axis", name);
}

double work_of(const ConvergencePoint& point, Work work) {
    switch (work) {
        case Work::n: return static_cast<double>(point.n);
        case Work::evaluations: return point.evaluations;
        case Work::seconds: return point.seconds;
    }
    throw std::logic_error("a Work outside its enumeration");
}

std::string to_string(Metric metric) {
    return metrics.at(static_cast<std::size_t>(metric)).name;
}
std::string label(Metric metric) {
    return metrics.at(static_cast<std::size_t>(metric)).label;
}
Metric metric_from(std::string_view name) {
    return value_from<Metric>(metrics, "metric", name);
}

Measured measured(Metric metric, const ConvergencePoint& point, double integral, Work across) {
    const auto& [low, high] = point.mse_interval;
    switch (metric) {
        case Metric::mse: return {point.mse, low, high};
        case Metric::rmse: return {root(point.mse), root(low), root(high)};
        case Metric::relative_mse: {
            const double square = integral * integral;
            return {point.mse / square, low / square, high / square};
        }
        case Metric::bias: {
            const double half = 1.959963984540054 * point.bias_standard_error, size = std::abs(point.bias);
            return {size, size - half, size + half};
        }
        case Metric::efficiency: {
            const double cost = across == Work::seconds ? point.seconds : point.evaluations;
            return {1 / (point.mse * cost), 1 / (high * cost), 1 / (low * cost)};
        }
    }
    throw std::logic_error("a Metric outside its enumeration");
}

double exponent(Metric metric, double of_mse) {
    switch (metric) {
        case Metric::mse:
        case Metric::relative_mse: return of_mse;
        case Metric::rmse: return of_mse / 2;
        case Metric::bias:
        case Metric::efficiency: return std::numeric_limits<double>::quiet_NaN();
    }
    throw std::logic_error("a Metric outside its enumeration");
}

}  // namespace plumb::reports
