#include "studies/headline.h"

#include <array>
#include <cmath>
#include <span>

#include "core/named.h"
#include "studies/study.h"
#include "verification/evidence/convergence.h"
#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

/// A number, or the logarithm of a positive one, with its standard error: infinite where it is not known.
struct Quantity {
    double value = 0, error = 0;
};

// Between two estimators, whose replicates are independent: a difference, or the logarithm of a ratio.
Quantity minus(const Quantity& a, const Quantity& b) {
    return {a.value - b.value, std::hypot(a.error, b.error)};
}

double known(double error) {
    return std::isfinite(error) && error > 0 ? error : std::numeric_limits<double>::infinity();
}

using Points = std::span<const ConvergencePoint>;

Quantity slope(Points points, double) {
    const Slope fitted = fit_slope({points.begin(), points.end()}, reports::headline_level);
    return {fitted.value, known(fitted.standard_error)};
}

Quantity relative_bias(Points points, double integral) {
    const ConvergencePoint& p = points.back();
    return {std::abs(p.bias / integral), known(std::abs(p.bias_standard_error / integral))};
}

// By the delta method, as the intervals of the MSE in every plot.
Quantity mse(Points points, double) {
    return {std::log(points.back().mse), known(points.back().log_mse_error)};
}

Quantity relative_mse(Points points, double integral) {
    const ConvergencePoint& p = points.back();
    const double value = p.mse / (integral * integral);
    return {value, known(value * p.log_mse_error)};
}

Quantity rmse(Points points, double integral) {
    const Quantity of_mse = mse(points, integral);
    return {of_mse.value / 2, of_mse.error / 2};
}

Quantity efficiency(Points points, double integral) {
    const Quantity of_mse = mse(points, integral);
    return {-of_mse.value - std::log(points.back().evaluations), of_mse.error};
}

Quantity seconds(Points points, double) {
    return {std::log(points.back().seconds), std::numeric_limits<double>::infinity()};
}

struct NamedMeasure {
    const char *name, *label;
    Quantity (*of)(Points points, double integral);
    bool logarithmic = true;  ///< `of` is a logarithm, and a comparison a ratio
    bool range = false, against = true;
    const char* indecisive = nullptr;  ///< why it decides nothing
};
constexpr std::array measures = {
    NamedMeasure{"slope", "slope of the MSE", slope, false, true},
    NamedMeasure{"mse", "MSE", mse},
    NamedMeasure{"rmse", "RMSE", rmse},
    NamedMeasure{"relative_mse", "MSE / I²", relative_mse, false},
    NamedMeasure{"relative_bias", "|bias / I|", relative_bias, false, false, false},
    NamedMeasure{"efficiency", "1 / (MSE × evaluations)", efficiency},
    NamedMeasure{.name = "seconds",
                 .label = "seconds",
                 .of = seconds,
                 .indecisive = "seconds depend on the machine and decide nothing"},
};

const NamedMeasure& find_measure(std::string_view name) {
    return find_named(measures, name, "measure", &NamedMeasure::name);
}

const Series& series_of(const reports::FigurePanel& panel, std::string_view estimator) {
    return *std::ranges::find(panel.series, estimator, &Series::estimator);
}

/// Up to `count` of the work that the figure is budgeted by.
std::size_t points_within(const Series& series, std::uint64_t count, bool in_evaluations) {
    const auto beyond = [&](const ConvergencePoint& p) {
        const double work = in_evaluations ? p.evaluations : static_cast<double>(p.n);
        return work > static_cast<double>(count) * (1 + 1e-9);
    };
    return static_cast<std::size_t>(std::ranges::find_if(series.points, beyond) - series.points.begin());
}

/// The points from one count to another; of an estimator that reaches no count, the nearest it has.
Points points_of(const Series& series, const HeadlinePlan& plan) {
    const std::size_t end = std::max<std::size_t>(1, points_within(series, plan.to, plan.in_evaluations));
    const std::size_t begin = std::max<std::size_t>(1, points_within(series, plan.from, plan.in_evaluations)) - 1;
    return Points(series.points).subspan(begin, end - begin);
}

/// "MSE of A / MSE of B on exp, n = 1024"
std::string in_words(const HeadlinePlan& plan, const NamedMeasure& measure) {
    std::string text = fmt::format("{} of {}", measure.label, plan.estimator);
    if (!plan.against.empty())
        text += fmt::format(" {} {} of {}", measure.logarithmic ? "/" : "−",
                            measure.logarithmic ? measure.label : "that", plan.against);
    text += fmt::format(" on {}, {} = {}", plan.integrand, plan.in_evaluations ? "evaluations" : "n", plan.from);
    return plan.from == plan.to ? text : fmt::format("{} to {}", text, plan.to);
}

Interval interval_of(const Quantity& quantity, const NamedMeasure& measure) {
    const double half = normal_upper_quantile((1 - reports::headline_level) / 2) * quantity.error;
    const Interval interval{quantity.value - half, quantity.value + half};
    if (measure.logarithmic) return {std::exp(interval.low), std::exp(interval.high)};
    return measure.against ? interval : Interval{std::max(0.0, interval.low), interval.high};  // a size is not negative
}

/// Why the number cannot be laid against the statement; empty where it can.
std::string obstacle(const Quantity& quantity, const NamedMeasure& measure) {
    if (measure.indecisive) return measure.indecisive;
    if (!std::isfinite(quantity.value)) return "the number is not defined: an error is 0 or not known";
    if (!std::isfinite(quantity.error)) return "the number has no error bar: the estimator is deterministic";
    return "";
}

}  // namespace

std::vector<std::string> headline_measures() {
    std::vector<std::string> names;
    for (const NamedMeasure& measure : measures) names.emplace_back(measure.name);
    return names;
}

bool measures_a_range(std::string_view measure) {
    return find_measure(measure).range;
}

bool measures_against(std::string_view measure) {
    return find_measure(measure).against;
}

reports::Headline measure_headline(const HeadlinePlan& plan, const reports::FigureResult& figure) {
    reports::Headline headline{
        .source = plan.source, .place = plan.place, .states = plan.states, .quoted = plan.quoted};
    headline.remark = plan.remark;
    headline.reason = plan.not_comparable;
    headline.value = std::numeric_limits<double>::quiet_NaN();
    if (plan.measure.empty()) return headline;

    const NamedMeasure& measure = find_measure(plan.measure);
    const auto& panel = *std::ranges::find(figure.panels, plan.integrand, &reports::FigurePanel::integrand);
    const auto of = [&](const std::string& estimator) {
        return measure.of(points_of(series_of(panel, estimator), plan), panel.integral);
    };
    Quantity quantity = of(plan.estimator);
    if (!plan.against.empty()) quantity = minus(quantity, of(plan.against));

    headline.figure = plan.figure;
    headline.measure = in_words(plan, measure);
    headline.stated = plan.stated;
    headline.value = measure.logarithmic ? std::exp(quantity.value) : quantity.value;
    headline.interval = interval_of(quantity, measure);
    headline.logarithmic = measure.logarithmic;
    headline.reason = obstacle(quantity, measure);
    headline.outcome = headline.reason.empty() ? reports::outcome_of(headline.stated, headline.interval)
                                               : reports::HeadlineOutcome::not_comparable;
    return headline;
}

std::vector<reports::Headline> measure_headlines(const Study& study,
                                                 const std::vector<reports::FigureResult>& figures) {
    std::vector<reports::Headline> headlines;
    for (const HeadlinePlan& plan : study.headlines) {
        const auto figure = std::ranges::find(figures, plan.figure, [](const auto& f) { return f.about.id; });
        if (plan.figure.empty())
            headlines.push_back(measure_headline(plan, {}));
        else if (figure != figures.end())
            headlines.push_back(measure_headline(plan, *figure));
    }
    return headlines;
}

}  // namespace plumb
