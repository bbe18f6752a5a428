#include "verification/evidence/mean.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "core/parallel.h"
#include "verification/evidence/betting.h"

namespace plumb {
namespace {

// Samples begin … begin + count − 1, drawn in parallel; each is a function of its index alone.
std::vector<double> draw_values(const Draw& draw, const Run& run, std::uint64_t begin, std::uint64_t count) {
    constexpr std::uint64_t batch = 256;
    std::vector<double> values(count);
    for_batches((count + batch - 1) / batch, [&](std::size_t b) {
        const std::uint64_t end = std::min<std::uint64_t>((b + 1) * batch, count);
        for (std::uint64_t i = b * batch; i < end; ++i) {
            RandomStream random = run.random(begin + i);
            values[i] = draw(random);
        }
    });
    return values;
}

// The bounds with room for the rounding of a value that sits on one of them.
Interval with_rounding(const Interval& bounds) {
    double scale = 0;
    for (const double end : {bounds.low, bounds.high})
        if (std::isfinite(end)) scale = std::max(scale, std::abs(end));
    return {bounds.low - 1e-12 * scale, bounds.high + 1e-12 * scale};
}

// The test sees (x − reference)/delta: nothing cancels beside a large reference, and no square under- or overflows.
struct Units {
    double reference, delta;

    [[nodiscard]] double of(double x) const { return (x - reference) / delta; }
    [[nodiscard]] Interval of(const Interval& x) const { return {of(x.low), of(x.high)}; }
};

// A value that no mean can survive, or that the claim's own bounds exclude; empty when all is well.
std::string defect_of(double value, std::uint64_t index, const Interval& bounds, const Units& units) {
    if (!std::isfinite(value)) return fmt::format("sample {} is {}", index, value);
    if (!bounds.contains(value))
        return fmt::format("sample {} is {:.17g}, outside the declared bounds [{:.17g}, {:.17g}]", index, value,
                           bounds.low, bounds.high);
    if (!std::isfinite(units.of(value)))
        return fmt::format("sample {} is {}, more than 1e308 times {} away from {}", index, value, units.delta,
                           units.reference);
    return {};
}

Verdict every_value_is(const Draw& draw, const MeanClaim& claim, const Run& run) {
    const std::uint64_t count = std::min<std::uint64_t>(claim.cap, std::max<std::uint64_t>(claim.min_samples, 4096));
    const std::vector<double> values = draw_values(draw, run, 0, count);
    double worst = 0;
    std::uint64_t worst_index = 0;
    for (std::uint64_t i = 0; i < count; ++i)
        if (const double off = std::abs(values[i] - claim.reference); !(off <= worst)) {
            worst = off;
            worst_index = i;
            if (std::isnan(off)) break;
        }
    Verdict verdict;
    verdict.samples = count;
    verdict.statistic = worst;
    verdict.resolution = claim.epsilon;
    verdict.deviation = {-worst, worst};
    verdict.outcome = worst <= claim.epsilon ? Outcome::holds : Outcome::refuted;
    verdict.reason = fmt::format("the worst of {} values, number {}, is {:.3g} from {:.17g}; claimed: at most {:.3g}",
                                 count, worst_index, worst, claim.reference, claim.epsilon);
    return verdict;
}

std::string undecided_reason(const MeanTest& test, std::uint64_t cap) {
    if (!test.tails_allow_a_decision())
        return fmt::format("heavy tails: the skewness {:.3g} of {} samples makes every interval of the mean worthless",
                           test.moments().skewness(), test.moments().count());
    return fmt::format("neither side was decided within the claim's {} samples", cap);
}

double mean_of(const MeanTest& test, const Units& units) {
    return units.reference + units.delta * test.moments().mean();
}

// What the test found, as a verdict about mean − reference; the sentences name what was claimed.
Verdict describe(const MeanTest& test, MeanTest::Decision decision, const Units& units, std::uint64_t cap) {
    const Moments& moments = test.moments();  // of (x − reference)/delta
    Verdict verdict;
    verdict.samples = moments.count();
    verdict.statistic = moments.mean() / moments.standard_error();
    verdict.p_value = test.p_value();
    const Interval bias = test.mean_interval();
    verdict.deviation = {units.delta * bias.low, units.delta * bias.high};
    verdict.resolution = units.delta;
    switch (decision) {
        case MeanTest::Decision::holds: verdict.outcome = Outcome::holds; break;
        case MeanTest::Decision::refuted: verdict.outcome = Outcome::refuted; break;
        case MeanTest::Decision::none: verdict.reason = undecided_reason(test, cap);
    }
    verdict.evidence = {{"mean", mean_of(test, units)},
                        {"standard_error", units.delta * moments.standard_error()},
                        {"reference", units.reference},
                        {"delta", units.delta},
                        {"skewness", moments.skewness()},
                        {"cap", cap},
                        {"cap_over_needed", static_cast<double>(cap) / (100 * moments.variance())},
                        {"risks", test.exact() ? std::string("exact: bounded values") : std::string("asymptotic")}};
    return verdict;
}

// Draws in waves and feeds the test block by block until it decides. Empty: read the test. Waves grow with what was
// consumed, so at most a quarter is drawn in vain; decisions are made in sample order and what was drawn past one is
// discarded, so that neither waves nor threads show in a verdict.
std::optional<Verdict> feed(MeanTest& test, MeanTest::Decision& decision, const Draw& draw, const Interval& bounds,
                            const Units& units, std::uint64_t cap, const Run& run) {
    std::uint64_t drawn = 0;
    while (decision == MeanTest::Decision::none && drawn < cap) {
        const std::uint64_t wave =
            std::min(cap - drawn, std::clamp<std::uint64_t>(drawn / 4 / 256 * 256, 1024, 1 << 18));
        std::vector<double> values = draw_values(draw, run, drawn, wave);
        for (std::uint64_t used = 0; used < wave && decision == MeanTest::Decision::none;) {
            const auto block = std::span(values).subspan(used, std::min<std::uint64_t>(test.block_size(), wave - used));
            for (std::size_t i = 0; i < block.size(); ++i) {
                if (std::string defect = defect_of(block[i], drawn + used + i, bounds, units); !defect.empty()) {
                    Verdict verdict;
                    verdict.outcome = Outcome::refuted;
                    verdict.samples = drawn + used + i + 1;
                    verdict.reason = std::move(defect);
                    return verdict;
                }
                block[i] = units.of(block[i]);
            }
            decision = test.add(block);
            used += block.size();
        }
        drawn += wave;
    }
    return {};
}

void check_setting(const MeanClaim& claim) {
    if (!(claim.delta > 0) && !claim.zero_variance) throw std::logic_error("mean_is: delta must be positive");
    if (!(claim.epsilon >= 0) || (!claim.zero_variance && claim.epsilon >= claim.delta))
        throw std::logic_error("mean_is: epsilon must be in [0, delta)");
    if (!std::isfinite(claim.reference)) throw std::logic_error("mean_is: the reference must be finite");
}

}  // namespace

Verdict mean_is(const Draw& draw, const MeanClaim& claim, const Run& run) {
    check_setting(claim);
    if (claim.zero_variance) return every_value_is(draw, claim, run);
    const Units units{claim.reference, claim.delta};
    const double allowed = claim.epsilon / claim.delta;
    const Interval bounds = with_rounding(claim.bounds);
    MeanTest test({{-allowed, allowed}, {-1, 1}, 1, units.of(bounds), run.alpha(), run.beta(), claim.min_samples});
    auto decision = MeanTest::Decision::none;
    if (std::optional<Verdict> defect = feed(test, decision, draw, bounds, units, claim.cap, run)) return *defect;
    Verdict verdict = describe(test, decision, units, claim.cap);
    verdict.evidence.emplace_back("epsilon", claim.epsilon);
    const double mean = mean_of(test, units), error = units.delta * test.moments().standard_error(),
                 bias = units.delta * test.moments().mean();
    if (decision == MeanTest::Decision::holds)
        verdict.reason = fmt::format("mean {:.9g} for {:.9g}: a bias of ±{:.2g} is excluded (risk {:.2g})", mean,
                                     claim.reference, claim.delta, run.beta());
    if (decision == MeanTest::Decision::refuted)
        verdict.reason = fmt::format("mean {:.9g} ± {:.2g} for {:.9g}: biased by {:+.3g} (p ≤ {:.1e})", mean, error,
                                     claim.reference, bias, verdict.p_value);
    return verdict;
}

Verdict mean_at_most(const Draw& draw, const AtMostClaim& claim, const Run& run) {
    if (!(claim.margin > 0)) throw std::logic_error("mean_at_most: margin must be positive");
    const Units units{claim.bound, claim.margin};
    const Interval below{-std::numeric_limits<double>::infinity(), 0};
    const Interval bounds = with_rounding(claim.bounds);
    MeanTest test({below, below, 1, units.of(bounds), run.alpha(), run.beta(), 0});
    auto decision = MeanTest::Decision::none;
    if (std::optional<Verdict> defect = feed(test, decision, draw, bounds, units, claim.cap, run)) return *defect;
    Verdict verdict = describe(test, decision, units, claim.cap);
    const double mean = mean_of(test, units), error = units.delta * test.moments().standard_error();
    if (decision == MeanTest::Decision::holds)
        verdict.reason =
            fmt::format("mean {:.4g} ± {:.2g}: at most {:.4g} (risk {:.2g})", mean, error, claim.bound, run.beta());
    if (decision == MeanTest::Decision::refuted)
        verdict.reason =
            fmt::format("mean {:.4g} ± {:.2g} exceeds {:.4g} (p ≤ {:.1e})", mean, error, claim.bound, verdict.p_value);
    return verdict;
}

}  // namespace plumb
