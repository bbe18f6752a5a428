#include "verification/evidence/rate.h"

#include <algorithm>
#include <cmath>

#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

// log(mse) is near normal only while the squares' mean is: beyond this error of one point, nothing is decided.
constexpr double largest_log_error = 0.25;

Interval slope_interval(const Slope& slope, double tail) {
    const double half = normal_upper_quantile(tail / 2) * slope.standard_error;
    return {slope.value - half, slope.value + half};
}

}  // namespace

Verdict rate_is(const Replicate& replicate, const ConvergenceSetting& setting, const Interval& exponents,
                const Run& run) {
    Series series = measure_convergence(replicate, setting, run);
    series.expected_slope = exponents;
    Verdict verdict;
    verdict.samples = setting.replicates * series.points.size();
    verdict.statistic = series.slope.value;
    const double middle = (exponents.low + exponents.high) / 2;
    verdict.resolution = exponents.width() / 2;
    const Interval sharp = slope_interval(series.slope, run.beta()), wide = slope_interval(series.slope, run.alpha());
    verdict.deviation = {sharp.low - middle, sharp.high - middle};
    // Two-sided p-value of the nearest slope that the claim allows.
    const double outside = std::max({exponents.low - series.slope.value, series.slope.value - exponents.high, 0.0});
    verdict.p_value = normal_two_sided_tail(outside / series.slope.standard_error);
    verdict.evidence = {{"slope", series.slope.value},      {"slope_standard_error", series.slope.standard_error},
                        {"claimed_low", exponents.low},     {"claimed_high", exponents.high},
                        {"replicates", setting.replicates}, {"n_first", setting.n.front()},
                        {"n_last", setting.n.back()}};
    const auto claimed = fmt::format("claimed {:.3g} … {:.3g}", exponents.low, exponents.high);
    const bool reliable = std::ranges::all_of(
        series.points, [](const ConvergencePoint& p) { return p.mse > 0 && p.log_mse_error <= largest_log_error; });
    const auto no_number =
        std::ranges::find_if(series.points, [](const ConvergencePoint& p) { return !std::isfinite(p.mse); });
    if (no_number != series.points.end()) {
        verdict.outcome = Outcome::refuted;
        verdict.reason = fmt::format("the MSE at n = {} is {}", no_number->n, no_number->mse);
    } else if (!reliable)
        verdict.reason = "an MSE is zero or its error exceeds 25 %: heavy tails, or too few replicates for a slope";
    else if (wide.disjoint(exponents)) {
        verdict.outcome = Outcome::refuted;
        verdict.reason = fmt::format("the MSE falls as n^{:.3f} ± {:.3f}; {}", series.slope.value,
                                     series.slope.standard_error, claimed);
    } else if (sharp.inside(exponents)) {
        verdict.outcome = Outcome::holds;
        verdict.reason = fmt::format("the MSE falls as n^{:.3f}, 99 % interval {:.3f} … {:.3f}; {}", series.slope.value,
                                     sharp.low, sharp.high, claimed);
    } else
        verdict.reason = fmt::format("99 % interval of the slope {:.3f} … {:.3f}; {}", sharp.low, sharp.high, claimed);
    verdict.series.push_back(std::move(series));
    return verdict;
}

}  // namespace plumb
