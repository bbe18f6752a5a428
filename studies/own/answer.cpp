#include "studies/own/answer.h"

#include "verification/evidence/convergence.h"

namespace plumb::own {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

ConvergencePoint spread_of(const Runs& runs) {
    ConvergencePoint point = convergence_point(runs.n, runs.estimates, mean_of(runs).value);
    const double count = static_cast<double>(runs.estimates.size()), unbiased = count / (count - 1);
    point.mse *= unbiased;
    point.mse_interval = {point.mse_interval.low * unbiased, point.mse_interval.high * unbiased};
    point.bias = point.bias_standard_error = not_known;
    return point;
}

// As many digits as the error leaves, and two more.
std::string readable_value(const Estimate& estimate) {
    const double value = estimate.value, error = estimate.standard_error;
    if (std::isinf(error)) return fmt::format("{} ± unknown", value);
    const double digits = value == 0 || error == 0 ? 17 : std::floor(std::log10(std::abs(value) / error)) + 3;
    return fmt::format("{:.{}g} ± {:.2g}", value, static_cast<int>(std::clamp(digits, 2.0, 17.0)), error);
}

std::string comparison(const Answer& answer) {
    const double deviation = answer.estimate.value - *answer.exact;
    const std::string in_errors =
        std::isinf(answer.estimate.standard_error)
            ? ""
            : fmt::format(", {:+.1f} standard errors", deviation / answer.estimate.standard_error);
    return fmt::format("  exact: {}; deviation {:+.2g}{}\n", *answer.exact, deviation, in_errors);
}

}  // namespace

std::string text_of(const Answer& a) {
    std::string text = fmt::format("{}\n  {}\n", a.integrand, readable_value(a.estimate));
    if (a.exact) text += comparison(a);
    text += fmt::format("  {}: {} of {} samples, {} evaluations", a.method,
                        a.runs == 1 ? "one set" : fmt::format("{} runs", a.runs), a.n, a.estimate.evaluations);
    if (a.all_evaluations > a.estimate.evaluations)
        text += fmt::format(" ({} with those that chose n or drew the plot)", a.all_evaluations);
    text += '\n';
    if (a.target)
        text += fmt::format("  target: a standard error of {:.2g}, {}\n", *a.target, a.target_met ? "met" : "not met");
    for (const std::string& sentence : a.known) text += fmt::format("  {}\n", sentence);
    return text;
}

reports::ListRow row_of(const Answer& a) {
    std::string known;
    for (const std::string& sentence : a.known) known += (known.empty() ? "" : "; ") + sentence;
    return {{"integrand", a.integrand},
            {"method", a.method},
            {"value", a.estimate.value},
            {"standard_error", a.estimate.standard_error},
            {"n", a.n},
            {"runs", a.runs},
            {"evaluations", a.estimate.evaluations},
            {"all_evaluations", a.all_evaluations},
            {"exact", a.exact.value_or(not_known)},
            {"target", a.target.value_or(not_known)},
            {"target_met", std::string(!a.target      ? ""
                                       : a.target_met ? "yes"
                                                      : "no")},
            {"known", known}};
}

Series series_of(const std::vector<Runs>& sets, const Answer& answer) {
    Series series;
    series.estimator = answer.method;
    series.integrand = answer.integrand;
    if (!answer.exact) series.integrand += " (variance; the integral is not known)";
    for (const Runs& runs : sets) {
        series.replicates = std::max<std::uint64_t>(series.replicates, runs.estimates.size());
        series.points.push_back(answer.exact ? convergence_point(runs.n, runs.estimates, *answer.exact)
                                             : spread_of(runs));
        series.points.back().seconds = runs.seconds;
    }
    series.slope = fit_slope(series.points, 0.95);
    return series;
}

}  // namespace plumb::own
