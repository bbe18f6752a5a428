// The error bars of estimates: the square of a reported standard error is unbiased, and intervals cover.
#include <cmath>
#include <numbers>

#include "estimators/points/mean_over.h"
#include "estimators/points/point_set_estimators.h"
#include "estimators/points/stratified.h"
#include "estimators/replicates/replicates.h"
#include "verification/claim.h"
#include "verification/evidence/mean.h"

namespace plumb::suites {
namespace {

/// e^x over n points that fill n strata, or one: what an error bar is asked about.
const Function<1> exponential = [](const Point<1>& p) { return std::exp(p[0]); };
const double integral = std::numbers::e - 1;

/// ∫ e^2x − (∫ e^x)² over [a, a + h], both over h.
double variance_within(double a, double h) {
    const double mean = std::exp(a) * std::expm1(h) / h;
    return std::exp(2 * a) * std::expm1(2 * h) / (2 * h) - mean * mean;
}

using ErrorBar = std::function<Estimate(RandomStream&)>;

/// Two values a and b from an interval of this width: their mean's squared standard error is (a − b)²/4.
Verdict square_is_unbiased(const ErrorBar& estimate, double variance, double width, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        const double error = estimate(random).standard_error;
        return error * error;
    };
    return mean_is(
        draw, {.reference = variance, .delta = 0.15 * variance, .bounds = {0, width * width}, .cap = 1 << 17}, run);
}

Estimate two_stratified_runs(RandomStream& random) {
    const auto run = [](const Function<1>& f, std::uint64_t n, RandomStream& stream) {
        return mean_over<1>(stratified_1d(n, stream), f);
    };
    return replicated<1>(run, exponential, 4, 2, random);
}

Estimate two_independent_points(RandomStream& random) {
    return mean_over_independent<1>(independent_points<1>(2, random), exponential);
}

/// The spread over n − 1 became one over n, n = 2.
ErrorBar divided_by_n(ErrorBar estimate) {
    return [estimate](RandomStream& random) {
        Estimate result = estimate(random);
        result.standard_error *= std::numbers::sqrt2 / 2;
        return result;
    };
}

/// The standard error of one value in place of that of the mean of two.
ErrorBar of_one_value(ErrorBar estimate) {
    return [estimate](RandomStream& random) {
        Estimate result = estimate(random);
        result.standard_error *= std::numbers::sqrt2;
        return result;
    };
}

/// The spread of the points of one stratified set, as if they were independent.
Estimate stratified_as_if_independent(RandomStream& random) {
    return mean_over_independent<1>(stratified_1d(8, random), exponential);
}

void add_squares(Catalogue& catalogue) {
    const double whole = variance_within(0, 1) / 2, range = std::numbers::e - 1;
    double strata = 0;
    for (int i = 0; i < 4; ++i) strata += variance_within(i / 4.0, 0.25) / 16;
    const auto check = [](double variance, double width) {
        return [=](const ErrorBar& estimate, const Run& run) {
            return square_is_unbiased(estimate, variance, width, run);
        };
    };
    const auto wrong = [](const ErrorBar& estimate) {
        return std::vector<Wrong<ErrorBar>>{
            {"variance-over-n", "The sum of squares is divided by n = 2, not n − 1.", divided_by_n(estimate)},
            {"of-one-value", "The standard error of one value, not of the mean of two.", of_one_value(estimate)}};
    };
    catalogue.add({
        .id = "error-bars/independent/squared-standard-error",
        .statement = "The squared standard error that two independent points report has the variance of their mean as "
                     "its expectation.",
        .source = "estimators/points/mean_over.h",
        .kind = Kind::mean,
        .trial = {check(whole, range), two_independent_points, wrong(two_independent_points)},
    });
    // Stratum by stratum a value of e^x moves within its increase, so the mean within (e − 1)/4.
    auto wrong_replicates = wrong(two_stratified_runs);
    wrong_replicates.push_back({"stratified-as-if-independent", "The spread of the points within one stratified set.",
                                stratified_as_if_independent});
    catalogue.add({
        .id = "error-bars/replicates/squared-standard-error",
        .statement = "The squared standard error of two stratified replicates has the variance of their mean as its "
                     "expectation.",
        .source = "estimators/replicates/replicates.h",
        .kind = Kind::mean,
        .trial = {check(strata / 2, range / 4), two_stratified_runs, std::move(wrong_replicates)},
    });
}

// A mean of 16 stratified points is close to normal: excess kurtosis near −1.2/16, skewness zero to first order. By the
// Edgeworth expansion of t the coverage is then off by less than 0.0003; epsilon leaves room for three times that.
Verdict interval_covers(double quantile, const Run& run) {
    const auto draw = [&](RandomStream& random) {
        const auto once = [](const Function<1>& f, std::uint64_t n, RandomStream& stream) {
            return mean_over<1>(stratified_1d(n, stream), f);
        };
        const Estimate estimate = replicated<1>(once, exponential, 16, 8, random);
        return std::abs(estimate.value - integral) <= quantile * estimate.standard_error ? 1.0 : 0.0;
    };
    return mean_is(draw, {.reference = 0.95, .delta = 0.0125, .epsilon = 0.001, .bounds = {0, 1}, .cap = 1 << 16}, run);
}

void add_coverage(Catalogue& catalogue) {
    constexpr double t_of_7_at_975 = 2.3646242515927849, normal_at_975 = 1.9599639845400543;
    catalogue.add({
        .id = "error-bars/replicates/coverage",
        .statement =
            "The 95 % interval from eight replicates, with Student's quantile, covers the integral in 95 % of runs.",
        .source = "[Student 1908]; estimators/replicates/replicates.h",
        .kind = Kind::mean,
        .trial = {interval_covers,
                  t_of_7_at_975,
                  {{"normal-quantile", "1.96, as if the spread were known: 90.9 % are covered.", normal_at_975}}},
    });
}

}  // namespace

void add_replicates_error_bars(Catalogue& catalogue) {
    add_squares(catalogue);
    add_coverage(catalogue);
}

}  // namespace plumb::suites
