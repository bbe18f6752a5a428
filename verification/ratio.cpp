#include "verification/ratio.h"

#include <cmath>

#include "core/moments.h"
#include "core/parallel.h"
#include "verification/distributions.h"

namespace plumb {
namespace {

Moments replicate_moments(const Draw& draw, std::uint64_t count, const Run& run) {
    constexpr std::uint64_t batch = 1024;
    std::vector<Moments> parts((count + batch - 1) / batch);
    for_batches(parts.size(), [&](std::size_t b) {
        for (std::uint64_t i = b * batch; i < std::min((b + 1) * batch, count); ++i) {
            RandomStream random = run.random(i);
            parts[b].add(draw(random));
        }
    });
    Moments all;
    for (const Moments& part : parts) all.merge(part);
    return all;
}

struct LogRatio {
    double value, standard_error;
};

// Is exp(value) inside the interval? The shared end of both verdicts below.
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
    const Moments ma = replicate_moments(a, claim.replicates, run.part("a")),
                  mb = replicate_moments(b, claim.replicates, run.part("b"));
    const double r = static_cast<double>(claim.replicates);
    const LogRatio ratio{std::log(ma.variance() * claim.cost_a / (mb.variance() * claim.cost_b)),
                         std::sqrt((ma.kurtosis() - 1) / r + (mb.kurtosis() - 1) / r)};
    return log_ratio_verdict(ratio, claim.ratio, 2 * claim.replicates, "variance × cost ratio", run);
}

Verdict variance_is(const Draw& draw, double variance, double relative_delta, std::uint64_t replicates,
                    const Run& run) {
    const Moments m = replicate_moments(draw, replicates, run);
    const LogRatio ratio{std::log(m.variance() / variance),
                         std::sqrt((m.kurtosis() - 1) / static_cast<double>(replicates))};
    return log_ratio_verdict(ratio, {1 - relative_delta, 1 + relative_delta}, replicates,
                             "measured over predicted variance", run);
}

}  // namespace plumb
