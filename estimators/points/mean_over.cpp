#include "estimators/points/mean_over.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/moments.h"

namespace plumb {
namespace {

template <int D>
std::vector<double> values_at(const std::vector<Point<D>>& points, const Function<D>& f) {
    if (points.empty()) throw Error("mean over a point set: no points; at least one is needed");
    std::vector<double> values(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        values[i] = f(points[i]);
        if (std::isnan(values[i]))
            throw Error(fmt::format("sample {}: f({}) is NaN; a number is needed", i, fmt::join(points[i], ", ")));
    }
    return values;
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

}  // namespace

template <int D>
Estimate mean_over(const std::vector<Point<D>>& points, const Function<D>& f) {
    return {.value = mean(values_at<D>(points, f)), .evaluations = points.size()};
}

template <int D>
Estimate mean_over_independent(const std::vector<Point<D>>& points, const Function<D>& f) {
    Estimate estimate{.evaluations = points.size()};
    const std::vector<double> values = values_at<D>(points, f);
    estimate.value = mean(values);
    Moments moments;
    for (const double value : values) moments.add(value);
    if (std::isfinite(estimate.value)) estimate.standard_error = moments.standard_error();
    return estimate;
}

template Estimate mean_over<1>(const std::vector<Point<1>>&, const Function<1>&);
template Estimate mean_over<2>(const std::vector<Point<2>>&, const Function<2>&);
template Estimate mean_over_independent<1>(const std::vector<Point<1>>&, const Function<1>&);
template Estimate mean_over_independent<2>(const std::vector<Point<2>>&, const Function<2>&);

}  // namespace plumb
