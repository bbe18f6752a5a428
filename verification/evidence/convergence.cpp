#include "verification/evidence/convergence.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/moments.h"
#include "core/parallel.h"
#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

ConvergencePoint measure_point(const Replicate& replicate, double truth, std::uint64_t n, std::uint64_t count,
                               const Run& run) {
    constexpr std::uint64_t batch = 16;
    std::vector<Estimate> replicates(count);
    const std::uint64_t batches = (count + batch - 1) / batch;
    std::vector<double> seconds(batches);
    for_batches(batches, [&](std::size_t b) {
        const auto start = std::chrono::steady_clock::now();
        for (std::uint64_t r = b * batch; r < std::min((b + 1) * batch, count); ++r) {
            RandomStream random = run.random(r);
            replicates[r] = replicate(n, random);
        }
        seconds[b] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    });
    ConvergencePoint point = convergence_point(n, replicates, truth);
    for (const double s : seconds) point.seconds += s / static_cast<double>(count);
    return point;
}

}  // namespace

ConvergencePoint convergence_point(std::uint64_t n, std::span<const Estimate> replicates, double truth) {
    ConvergencePoint point;
    point.n = n;
    Moments errors, squares;
    for (const Estimate& r : replicates) {
        const double error = r.value - truth;
        errors.add(error);
        squares.add(error * error);
        point.evaluations += static_cast<double>(r.evaluations);
    }
    point.evaluations /= static_cast<double>(replicates.size());
    point.bias = errors.mean();
    point.bias_standard_error = errors.standard_error();
    set_mse(point, squares.mean(), squares.standard_error());
    return point;
}

void set_mse(ConvergencePoint& point, double mse, double standard_error) {
    const double reach = normal_upper_quantile(0.025) * standard_error;
    point.mse = mse;
    point.log_mse_error = mse > 0 ? standard_error / mse : std::numeric_limits<double>::quiet_NaN();  // delta method
    point.mse_interval = mse > 0 ? Interval{mse * std::exp(-reach / mse), mse * std::exp(reach / mse)}
                                 : Interval{mse - reach, mse + reach};
}

void subtract_variance_of_truth(ConvergencePoint& point, const Interval& variance) {
    const double v = variance.high, of_replicates = point.mse > 0 ? point.log_mse_error * point.mse : 0;
    const double bias_squared = std::max(0.0, point.bias * point.bias - v);
    set_mse(point, point.mse - v, std::sqrt(of_replicates * of_replicates + 2 * v * v + 4 * v * bias_squared));
    point.mse_interval.high += variance.width();
    point.bias_standard_error = std::hypot(point.bias_standard_error, std::sqrt(v));
}

// Deterministic methods leave no error of their MSE: their points weigh the same and the slope has no interval.
Slope fit_slope(const std::vector<ConvergencePoint>& points, double level) {
    const auto known = [](const ConvergencePoint& p) { return p.log_mse_error > 0 && std::isfinite(p.log_mse_error); };
    const bool weighted = std::ranges::any_of(points, known);
    const auto each = [&](auto&& use) {
        for (const ConvergencePoint& p : points)
            if (p.mse > 0 && std::isfinite(p.mse) && (!weighted || known(p)))
                use(std::log(static_cast<double>(p.n)), std::log(p.mse),
                    weighted ? 1 / (p.log_mse_error * p.log_mse_error) : 1);
    };
    double weight = 0, x_mean = 0, y_mean = 0, xx = 0, xy = 0;
    each([&](double x, double y, double w) {
        weight += w;
        x_mean += w * x;
        y_mean += w * y;
    });
    x_mean /= weight;
    y_mean /= weight;
    each([&](double x, double y, double w) {
        xx += w * (x - x_mean) * (x - x_mean);
        xy += w * (x - x_mean) * (y - y_mean);
    });
    if (!(xx > 0)) return {};
    Slope slope{xy / xx, weighted ? std::sqrt(1 / xx) : std::numeric_limits<double>::infinity(), {}};
    const double half = normal_upper_quantile((1 - level) / 2) * slope.standard_error;
    slope.interval = {slope.value - half, slope.value + half};
    return slope;
}

Series measure_convergence(const Replicate& replicate, const ConvergenceSetting& setting, const Run& run) {
    Series series;
    series.estimator = setting.estimator;
    series.integrand = setting.integrand;
    series.replicates = setting.replicates;
    for (const std::uint64_t n : setting.n)
        series.points.push_back(
            measure_point(replicate, setting.truth, n, setting.replicates, run.part(fmt::format("n={}", n))));
    series.slope = fit_slope(series.points, 0.95);
    return series;
}

}  // namespace plumb
