#include "verification/evidence/ratio.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/moments.h"
#include "core/parallel.h"
#include "verification/evidence/distributions.h"

namespace plumb {
namespace {

// Moments of the replicates, and the first that is not a finite number.
struct Replicates {
    Moments moments;
    std::optional<std::uint64_t> not_finite;
};

Replicates replicate(const Draw& draw, std::uint64_t count, const Run& run) {
    constexpr std::uint64_t batch = 1024;
    std::vector<Replicates> parts((count + batch - 1) / batch);
    for_batches(parts.size(), [&](std::size_t b) {
        for (std::uint64_t i = b * batch; i < std::min((b + 1) * batch, count); ++i) {
            RandomStream random = run.random(i);
            const double x = draw(random);
            if (!std::isfinite(x) && !parts[b].not_finite) parts[b].not_finite = i;
            parts[b].moments.add(x);
        }
    });
    Replicates all;
    for (const Replicates& part : parts) {
        all.moments.merge(part.moments);
        if (!all.not_finite) all.not_finite = part.not_finite;
    }
    return all;
}

Verdict not_a_number(std::uint64_t replicate, std::string_view of) {
    Verdict verdict;
    verdict.outcome = Outcome::refuted;
    verdict.samples = replicate + 1;
    verdict.reason = fmt::format("replicate {} of {} is not a finite number", replicate, of);
    return verdict;
}

struct LogRatio {
    double value, standard_error;
};

// The verdict on whether exp(value) is inside the interval: the shared end of both verdicts below.
Verdict log_ratio_verdict(const LogRatio& ratio, const Interval& claimed, std::uint64_t samples, std::string_view what,
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
    if (!(ratio.standard_error <= 0.25))  // also NaN: zero sample variance decides nothing
        verdict.reason = "a variance is zero or its error exceeds 25 %: nothing is decided; " + numbers;
    else if (wide.disjoint(claimed))
        verdict.outcome = Outcome::refuted;
    else if (sharp.inside(claimed))
        verdict.outcome = Outcome::holds;
    return verdict;
}

}  // namespace

Verdict ratio_is(const Draw& a, const Draw& b, const RatioClaim& claim, const Run& run) {
    const Replicates of_a = replicate(a, claim.replicates, run.part("a")),
                     of_b = replicate(b, claim.replicates, run.part("b"));
    if (of_a.not_finite) return not_a_number(*of_a.not_finite, "a");
    if (of_b.not_finite) return not_a_number(*of_b.not_finite, "b");
    const Moments &ma = of_a.moments, &mb = of_b.moments;
    const double r = static_cast<double>(claim.replicates);
    const LogRatio ratio{std::log(ma.variance() * claim.cost_a / (mb.variance() * claim.cost_b)),
                         std::sqrt((ma.kurtosis() - 1) / r + (mb.kurtosis() - 1) / r)};
    return log_ratio_verdict(ratio, claim.ratio, 2 * claim.replicates, "variance × cost ratio", run);
}

Verdict mse_ratio_is(const Series& a, const Series& b, const Interval& ratio, const Run& run) {
    const ConvergencePoint &of_a = a.points.back(), &of_b = b.points.back();
    if (of_a.n != of_b.n) throw std::logic_error("a ratio of MSEs at different numbers of samples");
    const LogRatio measured{std::log(of_a.mse / of_b.mse), std::hypot(of_a.log_mse_error, of_b.log_mse_error)};
    return log_ratio_verdict(measured, ratio, a.replicates + b.replicates,
                             fmt::format("{} over {} at n = {}: MSE ratio", a.estimator, b.estimator, of_a.n), run);
}

Verdict variance_is(const Draw& draw, double variance, double relative_delta, std::uint64_t replicates,
                    const Run& run) {
    const Replicates all = replicate(draw, replicates, run);
    if (all.not_finite) return not_a_number(*all.not_finite, "the estimator");
    const Moments& m = all.moments;
    const LogRatio ratio{std::log(m.variance() / variance),
                         std::sqrt((m.kurtosis() - 1) / static_cast<double>(replicates))};
    return log_ratio_verdict(ratio, {1 - relative_delta, 1 + relative_delta}, replicates,
                             "measured over predicted variance", run);
}

}  // namespace plumb
