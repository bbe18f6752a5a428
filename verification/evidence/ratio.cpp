#include "verification/evidence/ratio.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/moments.h"
#include "core/parallel.h"
#include "verification/evidence/convergence.h"
#include "verification/evidence/distributions.h"
#include "verification/evidence/independence.h"
#include "verification/evidence/log_mean.h"
#include "verification/evidence/rare_values.h"

namespace plumb {
namespace {

std::vector<double> replicate(const Draw& draw, std::uint64_t begin, std::uint64_t count, const Run& run) {
    constexpr std::uint64_t batch = 1024;
    std::vector<double> values(count);
    for_batches((count + batch - 1) / batch, [&](std::size_t b) {
        for (std::uint64_t i = b * batch; i < std::min((b + 1) * batch, count); ++i) {
            RandomStream random = run.random(begin + i);
            values[i] = draw(random);
        }
    });
    return values;
}

// The logarithm of the values' variance.
LogMean log_variance(const std::vector<double>& values) {
    const Moments moments = Moments::of(values);
    std::vector<double> squares;
    squares.reserve(values.size());
    for (const double x : values) squares.push_back((x - moments.mean()) * (x - moments.mean()));
    LogMean log = log_mean(Moments::of(squares));
    log.value = std::log(moments.variance());
    return log;
}

// What values show of themselves: a variance that exists, or why there is none to speak of.
std::optional<Verdict> trouble_of(const std::vector<double>& values, std::uint64_t begin, const Draw& draw,
                                  std::string_view of, const Run& run) {
    Verdict verdict;
    const auto bad = std::ranges::find_if(values, [](double x) { return !std::isfinite(x); });
    if (bad != values.end()) {
        verdict.outcome = Outcome::refuted;
        verdict.samples = begin + static_cast<std::uint64_t>(bad - values.begin()) + 1;
        verdict.reason = fmt::format("replicate {} of {} is not a finite number", verdict.samples - 1, of);
        return verdict;
    }
    Independence independence;
    independence.add(values);
    verdict.samples = begin + values.size();
    verdict.reason = begin == 0 ? complaint_of_state(draw, values, run) : "";
    if (verdict.reason.empty()) verdict.reason = independence.complaint();
    return verdict.reason.empty() ? std::nullopt : std::optional(verdict);
}

std::string doubt_of(const LogMean& ratio, std::uint64_t samples) {
    if (!(ratio.standard_error <= largest_log_error))  // also NaN: zero sample variance decides nothing
        return "a variance is zero or its error exceeds 25 %: nothing is decided; ";
    return fmt::format("heavy tails: {} values are too few for squares so skew; ", with_commas(samples));
}

// The verdict on whether exp(value) is inside the interval: the shared end of all verdicts below.
Verdict log_ratio_verdict(const LogMean& ratio, const Interval& claimed, std::uint64_t samples, std::string_view what,
                          const Run& run) {
    const auto interval = [&](double tail) {
        const double half = normal_upper_quantile(tail / 2) * ratio.standard_error;
        return Interval{std::exp(ratio.value - half), std::exp(ratio.value + half)};
    };
    const Interval sharp = interval(run.beta()), wide = interval(run.alpha());
    Verdict verdict;
    verdict.samples = samples;
    verdict.statistic = std::exp(ratio.value);
    const double middle = (claimed.low + claimed.high) / 2;
    verdict.deviation = {sharp.low - middle, sharp.high - middle};
    verdict.resolution = claimed.width() / 2;
    const double outside = std::max({std::log(claimed.low) - ratio.value, ratio.value - std::log(claimed.high), 0.0});
    verdict.p_value = normal_two_sided_tail(outside / ratio.standard_error);
    verdict.evidence = {{"ratio", std::exp(ratio.value)},
                        {"log_ratio_standard_error", ratio.standard_error},
                        {"claimed_low", claimed.low},
                        {"claimed_high", claimed.high}};
    const auto numbers = fmt::format("{} {:.4g}, 99 % interval {:.4g} … {:.4g}; claimed {:.4g} … {:.4g}", what,
                                     std::exp(ratio.value), sharp.low, sharp.high, claimed.low, claimed.high);
    verdict.reason = numbers;
    const bool known = ratio.standard_error <= largest_log_error;
    const double at_alpha = ratio.distortion(normal_upper_quantile(run.alpha() / 2)),
                 at_beta = ratio.distortion(normal_upper_quantile(run.beta() / 2));
    if (known && wide.disjoint(claimed) && at_alpha <= refutable_distortion)
        verdict.outcome = Outcome::refuted;
    else if (known && sharp.inside(claimed) && at_beta <= interval_distortion)
        verdict.outcome = Outcome::holds;
    else if (!known || wide.disjoint(claimed) || sharp.inside(claimed))
        verdict.reason = doubt_of(ratio, samples) + numbers;
    return verdict;
}

// A verdict on replicates begin … begin + count − 1.
using Measure = std::function<Verdict(std::uint64_t begin, std::uint64_t count)>;

// As of mean claims: without a reason for fewer, enough values to meet rare ones, and a refutation is tried again.
Verdict on_guard(const Measure& measure, std::uint64_t replicates, const std::string& why_fewer) {
    if (!why_fewer.empty()) {
        Verdict verdict = measure(0, replicates);
        verdict.evidence.emplace_back("rests_on", why_fewer);
        return verdict;
    }
    const std::uint64_t first = std::max(replicates, least_draws_without_bounds), fresh = confirming_draws(first);
    Verdict verdict = measure(0, first);
    const bool by_values = !verdict.evidence.empty();  // not by one that is no number
    if (verdict.outcome == Outcome::refuted && by_values) {
        const std::string reason = verdict.reason;
        verdict = measure(first, fresh);
        if (verdict.outcome != Outcome::refuted) {
            verdict.outcome = Outcome::undecided;
            verdict.reason = fmt::format("{} replicates refute, {} fresh ones do not confirm it ({}; fresh: {})",
                                         with_commas(first), with_commas(fresh), reason, verdict.reason);
        }
        verdict.samples += first;
    }
    if (verdict.outcome != Outcome::undecided && by_values)
        verdict.reason += "; " + what_could_hide(verdict.outcome == Outcome::refuted ? first + fresh : first);
    return verdict;
}

}  // namespace

Verdict ratio_is(const Draw& a, const Draw& b, const RatioClaim& claim, const Run& run) {
    const Run of_a = run.part("a"), of_b = run.part("b");
    const auto measure = [&](std::uint64_t begin, std::uint64_t count) {
        const std::vector<double> values_a = replicate(a, begin, count, of_a),
                                  values_b = replicate(b, begin, count, of_b);
        if (const auto trouble = trouble_of(values_a, begin, a, "a", of_a)) return *trouble;
        if (const auto trouble = trouble_of(values_b, begin, b, "b", of_b)) return *trouble;
        LogMean ratio = log_ratio(log_variance(values_a), log_variance(values_b));
        ratio.value += std::log(claim.cost_a / claim.cost_b);
        return log_ratio_verdict(ratio, claim.ratio, 2 * count, "variance × cost ratio", run);
    };
    return on_guard(measure, claim.replicates, claim.why_fewer);
}

Verdict mse_ratio_is(const Series& a, const Series& b, const Interval& ratio, const Run& run) {
    const ConvergencePoint &of_a = a.points.back(), &of_b = b.points.back();
    if (of_a.n != of_b.n) throw std::logic_error("a ratio of MSEs at different numbers of samples");
    return log_ratio_verdict(log_ratio(log_mse_of(of_a), log_mse_of(of_b)), ratio, a.replicates + b.replicates,
                             fmt::format("{} over {} at n = {}: MSE ratio", a.estimator, b.estimator, of_a.n), run);
}

Verdict variance_is(const Draw& draw, double variance, double relative_delta, std::uint64_t replicates, const Run& run,
                    const std::string& why_fewer) {
    const auto measure = [&](std::uint64_t begin, std::uint64_t count) {
        const std::vector<double> values = replicate(draw, begin, count, run);
        if (const auto trouble = trouble_of(values, begin, draw, "the estimator", run)) return *trouble;
        LogMean ratio = log_variance(values);
        ratio.value -= std::log(variance);
        return log_ratio_verdict(ratio, {1 - relative_delta, 1 + relative_delta}, count,
                                 "measured over predicted variance", run);
    };
    return on_guard(measure, replicates, why_fewer);
}

}  // namespace plumb
