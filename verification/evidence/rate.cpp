#include "verification/evidence/rate.h"

#include <algorithm>
#include <cmath>

#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

Interval around(const LogMean& value, double tail) {
    const double half = normal_upper_quantile(tail / 2) * value.standard_error;
    return {value.value - half, value.value + half};
}

// A rate claim on its measured series: each question in turn, the sentence with it.
struct RateTest {
    const Series& series;
    Interval exponents;
    double alpha, beta;
    std::vector<Misfit> pairs = misfits(series.points, exponents);
    LogMean slope = fitted_exponent(series.points);

    [[nodiscard]] std::string claimed() const {
        return fmt::format("claimed {:.3g} … {:.3g}", exponents.low, exponents.high);
    }
    [[nodiscard]] double count() const { return static_cast<double>(pairs.size()); }

    [[nodiscard]] std::string no_number() const {
        const auto bad = std::ranges::find_if(series.points, [](const auto& p) { return !std::isfinite(p.mse); });
        return bad == series.points.end() ? "" : fmt::format("the MSE at n = {} is {}", bad->n, bad->mse);
    }
    [[nodiscard]] std::string refutation() const {
        const double outside = std::max({exponents.low - slope.value, slope.value - exponents.high, 0.0});
        if (outside > slope.quantile(normal_upper_quantile(alpha / 4)) * slope.standard_error)
            return fmt::format("the MSE falls as n^{:.3f} ± {:.3f}; {}", slope.value, slope.standard_error, claimed());
        const double z = normal_upper_quantile(alpha / 4 / count());
        const auto off = std::ranges::find_if(
            pairs, [&](const Misfit& pair) { return pair.excess > pair.drop.quantile(z) * pair.drop.standard_error; });
        if (off == pairs.end()) return {};
        const auto doublings = std::log(static_cast<double>(off->n_last) / static_cast<double>(off->n_first));
        return fmt::format("no power law: from n = {} to {} the MSE goes as n^{:.3f} ± {:.3f}, overall as n^{:.3f}; {}",
                           off->n_first, off->n_last, off->exponent, off->drop.standard_error / doublings, slope.value,
                           claimed());
    }
    /// What keeps it from holding: a pair that leaves the claim at 1 % of all pairs, or might by more than the claim's
    /// own half width makes over the whole range.
    [[nodiscard]] std::string open_step() const {
        const double z = normal_upper_quantile(beta / 2), z_of_all = normal_upper_quantile(beta / 2 / count());
        const auto &first = series.points.front(), &last = series.points.back();
        const double reach =
            exponents.width() / 2 * std::log(static_cast<double>(last.n) / static_cast<double>(first.n));
        for (const Misfit& pair : pairs)
            if (pair.excess > std::min(z_of_all * pair.drop.standard_error, reach - z * pair.drop.standard_error))
                return fmt::format("between n = {} and {} the MSE goes as n^{:.3f}: a step could hide; {}",
                                   pair.n_first, pair.n_last, pair.exponent, claimed());
        return {};
    }
};

constexpr int fresh_runs = 4;

// The level of each of the fresh runs, all of which must refute: they are independent, so that their levels multiply.
double fresh_level(double alpha) {
    return std::pow(alpha, 1.0 / fresh_runs);
}

// Tails that leave one run undecided at a small level do less at its fourth root.
bool fresh_runs_refute(const Replicate& replicate, const ConvergenceSetting& setting, const Interval& exponents,
                       double alpha, const Run& run) {
    for (int i = 0; i < fresh_runs; ++i) {
        const Series series = measure_convergence(replicate, setting, run.part(fmt::format("fresh {}", i), 1));
        if (RateTest{series, exponents, fresh_level(alpha), run.beta()}.refutation().empty()) return false;
    }
    return true;
}

}  // namespace

Verdict rate_is(const Replicate& replicate, const ConvergenceSetting& setting, const Interval& exponents,
                const Run& run) {
    Series series = measure_convergence(replicate, setting, run);
    series.expected_slope = exponents;
    const RateTest test{series, exponents, run.alpha() / 2, run.beta()};
    Verdict verdict;
    verdict.samples = setting.replicates * series.points.size();
    verdict.statistic = series.slope.value;
    const double middle = (exponents.low + exponents.high) / 2;
    verdict.resolution = exponents.width() / 2;
    const Interval sharp = around(test.slope, run.beta());
    verdict.deviation = {sharp.low - middle, sharp.high - middle};
    // Two-sided p-value of the nearest slope that the claim allows.
    const double outside = std::max({exponents.low - series.slope.value, series.slope.value - exponents.high, 0.0});
    verdict.p_value = normal_two_sided_tail(outside / series.slope.standard_error);
    verdict.evidence = {{"slope", series.slope.value},      {"slope_standard_error", series.slope.standard_error},
                        {"claimed_low", exponents.low},     {"claimed_high", exponents.high},
                        {"replicates", setting.replicates}, {"n_first", setting.n.front()},
                        {"n_last", setting.n.back()}};
    const bool zero = std::ranges::any_of(series.points, [](const ConvergencePoint& p) { return !(p.mse > 0); });
    if (const std::string bad = test.no_number(); !bad.empty()) {
        verdict.outcome = Outcome::refuted;
        verdict.reason = bad;
    } else if (zero || !sharp.bounded())
        verdict.reason = zero ? "an MSE is zero" : series.slope.doubt;
    else if (const std::string refutation = test.refutation(); !refutation.empty()) {
        verdict.outcome = Outcome::refuted;
        verdict.reason = refutation;
    } else if (sharp.disjoint(exponents) && fresh_runs_refute(replicate, setting, exponents, run.alpha() / 2, run)) {
        verdict.outcome = Outcome::refuted;
        verdict.samples *= 1 + fresh_runs;
        verdict.reason = fmt::format(
            "the MSE falls as n^{:.3f} ± {:.3f}; {}; with heavy tails, so {} fresh runs refute it too, each at {:.2g}",
            test.slope.value, test.slope.standard_error, test.claimed(), fresh_runs, fresh_level(run.alpha() / 2));
    } else if (!sharp.inside(exponents))
        verdict.reason =
            fmt::format("99 % interval of the slope {:.3f} … {:.3f}; {}", sharp.low, sharp.high, test.claimed());
    else if (const std::string step = test.open_step(); !step.empty())
        verdict.reason = step;
    else {
        verdict.outcome = Outcome::holds;
        verdict.reason = fmt::format("the MSE falls as n^{:.3f}, 99 % interval {:.3f} … {:.3f}; {}", series.slope.value,
                                     sharp.low, sharp.high, test.claimed());
    }
    verdict.series.push_back(std::move(series));
    return verdict;
}

}  // namespace plumb
