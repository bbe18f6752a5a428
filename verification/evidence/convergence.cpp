#include "verification/evidence/convergence.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

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

bool has_error(const ConvergencePoint& p) {
    return p.mse > 0 && p.log_mse_error > 0 && std::isfinite(p.log_mse_error);
}

constexpr double z_of_99_percent = 2.5758293035489004;

// Why errors of points give no interval of a slope: log MSE is near normal only while the squares' mean is.
std::string doubt_of_errors(const std::vector<ConvergencePoint>& points, const LogMean& slope) {
    for (const ConvergencePoint& p : points) {
        if (!(p.mse > 0) || !std::isfinite(p.mse)) continue;
        if (!has_error(p)) return fmt::format("undecided: the runs at n = {} show no spread", p.n);
        if (p.log_mse_error > largest_log_error)
            return fmt::format("undecided: the error of the MSE at n = {} is {:.0f} %: heavy tails, or too few runs",
                               p.n, 100 * p.log_mse_error);
    }
    if (slope.distortion(z_of_99_percent) > interval_distortion)
        return "undecided: heavy tails make every interval worthless";
    return {};
}

std::string doubt_of_fit(const std::vector<ConvergencePoint>& points, double exponent) {
    constexpr double allowed = 0.25, level = 0.01;
    const std::vector<Misfit> pairs = misfits(points, {exponent - allowed, exponent + allowed});
    if (pairs.empty()) return {};
    const Misfit& worst = pairs.front();
    const double p = normal_two_sided_tail(worst.excess / worst.drop.standard_error);
    if (p * static_cast<double>(pairs.size()) >= level) return {};
    return fmt::format("no power law: from n = {} to {} the MSE goes as n^{:.2f}", worst.n_first, worst.n_last,
                       worst.exponent);
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
    if (squares.variance() > 0 && squares.count() > 1) {
        const LogMean log = log_mean(squares);
        point.log_mse_skewness = log.skewness;
        point.log_mse_kurtosis = log.kurtosis;
    }
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

LogMean log_mse_of(const ConvergencePoint& point) {
    return {.value = std::log(point.mse),
            .standard_error = point.log_mse_error,
            .skewness = point.log_mse_skewness,
            .kurtosis = point.log_mse_kurtosis};
}

std::vector<Misfit> misfits(const std::vector<ConvergencePoint>& points, const Interval& exponents) {
    std::vector<Misfit> pairs;
    for (std::size_t j = 1; j < points.size(); ++j)
        for (std::size_t i = 0; i < j; ++i) {
            const ConvergencePoint &a = points[i], &b = points[j];
            if (!has_error(a) || !has_error(b) || a.n == b.n) continue;
            const double doublings = std::log(static_cast<double>(b.n) / static_cast<double>(a.n));
            const LogMean drop = log_ratio(log_mse_of(b), log_mse_of(a));
            const Interval allowed{exponents.low * doublings, exponents.high * doublings};
            const double excess = std::max({allowed.low - drop.value, drop.value - allowed.high, 0.0});
            pairs.push_back({a.n, b.n, drop.value / doublings, excess, drop});
        }
    std::ranges::sort(pairs, std::greater(), [](const Misfit& m) { return m.excess / m.drop.standard_error; });
    return pairs;
}

// The weighted sum of the logarithms that is the least-squares slope; points without an error weigh the same when there
// are no others.
LogMean fitted_exponent(const std::vector<ConvergencePoint>& points) {
    const bool weighted = std::ranges::any_of(points, has_error);
    std::vector<double> x, weights;
    std::vector<LogMean> logs;
    for (const ConvergencePoint& p : points) {
        if (!(p.mse > 0) || !std::isfinite(p.mse) || (weighted && !has_error(p))) continue;
        x.push_back(std::log(static_cast<double>(p.n)));
        logs.push_back(log_mse_of(p));
        weights.push_back(weighted ? 1 / (p.log_mse_error * p.log_mse_error) : 1);
    }
    const double weight = std::accumulate(weights.begin(), weights.end(), 0.0);
    const double middle = std::inner_product(x.begin(), x.end(), weights.begin(), 0.0) / weight;
    double spread = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        spread += weights[i] * (x[i] - middle) * (x[i] - middle);
        weights[i] *= x[i] - middle;
    }
    for (double& w : weights) w /= spread;
    LogMean slope = combination(logs, weights);
    if (!(spread > 0)) slope.value = std::numeric_limits<double>::quiet_NaN();
    return slope;
}

Slope fit_slope(const std::vector<ConvergencePoint>& points, double level) {
    const LogMean fitted = fitted_exponent(points);
    if (std::isnan(fitted.value)) return {};
    Slope slope{fitted.value, std::numeric_limits<double>::infinity(), {}, {}};
    if (std::ranges::none_of(points, has_error)) return slope;  // a deterministic method
    slope.doubt = doubt_of_errors(points, fitted);
    if (!slope.doubt.empty()) return slope;
    slope.standard_error = fitted.standard_error;
    const double half = normal_upper_quantile((1 - level) / 2) * fitted.standard_error;
    slope.interval = {slope.value - half, slope.value + half};
    slope.doubt = doubt_of_fit(points, slope.value);
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
