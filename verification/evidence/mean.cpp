#include "verification/evidence/mean.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "core/parallel.h"
#include "verification/evidence/betting.h"
#include "verification/evidence/independence.h"
#include "verification/evidence/rare_values.h"

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

// What is asked of the values: mean_is and mean_at_most differ in it alone.
struct Question {
    Interval allowed, resolved;  // means in units
    Units units;
    Interval bounds;  // of one value, with room for rounding
    std::uint64_t min_samples;
    const std::string& why_fewer;
    std::uint64_t cap;

    [[nodiscard]] bool bounded() const { return std::isfinite(bounds.low) && std::isfinite(bounds.high); }
    /// Nothing is known of rare values: what a sample lacks could be anything.
    [[nodiscard]] bool on_its_guard() const { return !bounded() && why_fewer.empty(); }
    [[nodiscard]] std::uint64_t least_draws() const {
        return on_its_guard() ? std::max(min_samples, least_draws_without_bounds) : min_samples;
    }
    [[nodiscard]] MeanTest test(std::uint64_t least, const Run& run) const {
        return MeanTest({allowed, resolved, 1, units.of(bounds), run.alpha(), run.beta(), least});
    }
};

// Gives a test its values in the order of their indices, and sees what the values show of themselves.
class Feed {
public:
    Feed(const Draw& draw, const Question& question, const Run& run) : draw_(draw), question_(question), run_(run) {}

    // Draws from `begin` on in waves until the test decides or has seen `most`. Waves grow with what was consumed, so
    // at most a quarter is drawn in vain; decisions are made in sample order and what was drawn past one is discarded,
    // so that neither waves nor threads show in a verdict.
    MeanTest::Decision until_decided(MeanTest& test, std::uint64_t begin, std::uint64_t most) {
        auto decision = MeanTest::Decision::none;
        for (std::uint64_t drawn = 0;
             decision == MeanTest::Decision::none && drawn < most && trouble_.empty() && state_.empty();) {
            const std::uint64_t wave =
                std::min(most - drawn, std::clamp<std::uint64_t>(drawn / 4 / 256 * 256, 1024, 1 << 18));
            std::vector<double> values = draw_values(draw_, run_, begin + drawn, wave);
            if (begin + drawn == 0) state_ = complaint_of_state(draw_, values, run_);
            if (state_.empty()) decision = take(test, values, begin + drawn);
            drawn += wave;
        }
        return decision;
    }

    /// A value that refutes by itself, or draws that a mean says nothing about; empty when all is well.
    [[nodiscard]] std::optional<Verdict> verdict(std::uint64_t samples) const {
        Verdict verdict;
        verdict.samples = samples;
        if (!trouble_.empty()) {
            verdict.outcome = Outcome::refuted;
            verdict.samples = defect_at_ + 1;
            verdict.reason = trouble_;
            return verdict;
        }
        verdict.reason = state_.empty() ? independence_.complaint() : state_;
        if (!state_.empty()) verdict.samples = draws_again;
        return verdict.reason.empty() ? std::nullopt : std::optional(verdict);
    }

private:
    MeanTest::Decision take(MeanTest& test, std::vector<double>& values, std::uint64_t begin) {
        auto decision = MeanTest::Decision::none;
        for (std::uint64_t used = 0; used < values.size() && decision == MeanTest::Decision::none;) {
            const auto block =
                std::span(values).subspan(used, std::min<std::uint64_t>(test.block_size(), values.size() - used));
            for (std::size_t i = 0; i < block.size(); ++i) {
                defect_at_ = begin + used + i;
                trouble_ = defect_of(block[i], defect_at_, question_.bounds, question_.units);
                if (!trouble_.empty()) return decision;
            }
            independence_.add(block);
            for (double& value : block) value = question_.units.of(value);
            decision = test.add(block);
            used += block.size();
        }
        return decision;
    }

    const Draw& draw_;
    const Question& question_;
    const Run& run_;
    Independence independence_;
    std::string trouble_, state_;
    std::uint64_t defect_at_ = 0;
};

std::string undecided_reason(const MeanTest& test, const Question& question) {
    const double n = static_cast<double>(test.moments().count()), skewness = test.moments().skewness();
    if (!test.tails_allow_a_decision())
        return fmt::format("heavy tails: the skewness {:.3g} of {} samples makes every interval of the mean worthless",
                           skewness, n);
    if (question.cap < question.least_draws())
        return fmt::format("values without bounds: nothing is decided before {} samples, and the claim's cap is {}",
                           with_commas(question.least_draws()), with_commas(question.cap));
    return fmt::format("neither side was decided within the claim's {} samples", question.cap);
}

double mean_of(const MeanTest& test, const Units& units) {
    return units.reference + units.delta * test.moments().mean();
}

// What the test found, as a verdict about mean − reference; the sentences name what was claimed.
Verdict describe(const MeanTest& test, MeanTest::Decision decision, const Question& question) {
    const Moments& moments = test.moments();  // of (x − reference)/delta
    const Units& units = question.units;
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
        case MeanTest::Decision::none: verdict.reason = undecided_reason(test, question);
    }
    const double skewness = test.exact() ? 0 : moments.skewness(), cap = static_cast<double>(question.cap);
    verdict.evidence = {{"mean", mean_of(test, units)},
                        {"standard_error", units.delta * moments.standard_error()},
                        {"reference", units.reference},
                        {"delta", units.delta},
                        {"skewness", moments.skewness()},
                        {"cap", question.cap},
                        {"cap_over_needed", cap / std::max(100 * moments.variance(), 3000 * skewness * skewness)},
                        {"risks", test.exact() ? std::string("exact: bounded values") : std::string("asymptotic")}};
    if (!question.why_fewer.empty()) verdict.evidence.emplace_back("rests_on", question.why_fewer);
    return verdict;
}

struct Answer {
    Verdict verdict;
    double mean = 0, standard_error = 0, bias = 0;
    std::string caveat = {};  // behind a reason
};

// A refutation that rests on what was seen is tried again on fresh values, several times as many.
Answer answer(const Draw& draw, const Question& question, const Run& run) {
    Feed feed(draw, question, run);
    MeanTest test = question.test(question.least_draws(), run);
    auto decision = feed.until_decided(test, 0, question.cap);
    const std::uint64_t first = test.moments().count(), fresh = confirming_draws(first);
    const bool to_confirm =
        decision == MeanTest::Decision::refuted && question.on_its_guard() && !test.refuted_exactly();
    if (to_confirm) {
        test = question.test(fresh, run);
        decision = feed.until_decided(test, first, 2 * fresh);
    }
    const std::uint64_t samples = to_confirm ? first + test.moments().count() : first;
    if (std::optional<Verdict> another = feed.verdict(samples)) return {*another};
    const bool confirmed = decision == MeanTest::Decision::refuted;
    if (to_confirm && !confirmed) decision = MeanTest::Decision::none;
    Answer answer{describe(test, decision, question), mean_of(test, question.units),
                  question.units.delta * test.moments().standard_error(), question.units.delta * test.moments().mean()};
    answer.verdict.samples = samples;
    if (question.on_its_guard() && decision != MeanTest::Decision::none && !test.refuted_exactly())
        answer.caveat = "; " + what_could_hide(samples);
    if (to_confirm) answer.verdict.evidence.emplace_back("confirming_samples", test.moments().count());
    if (to_confirm && !confirmed)
        answer.verdict.reason = fmt::format(
            "{} samples refute, {} fresh ones do not confirm it: rare values carry much of the mean; declare bounds, "
            "or "
            "min_samples of 16 over their probability",
            with_commas(first), with_commas(test.moments().count()));
    return answer;
}

Question question(const auto& claim, const Interval& allowed, const Interval& resolved, const Units& units) {
    return {.allowed = allowed,
            .resolved = resolved,
            .units = units,
            .bounds = with_rounding(claim.bounds),
            .min_samples = claim.min_samples,
            .why_fewer = claim.why_fewer,
            .cap = claim.cap};
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
    const double allowed = claim.epsilon / claim.delta;
    auto [verdict, mean, error, bias, caveat] =
        answer(draw, question(claim, {-allowed, allowed}, {-1, 1}, {claim.reference, claim.delta}), run);

    if (verdict.evidence.empty()) return verdict;
    verdict.evidence.emplace_back("epsilon", claim.epsilon);
    if (verdict.outcome == Outcome::holds)
        verdict.reason = fmt::format("mean {:.9g} for {:.9g}: a bias of ±{:.2g} is excluded (risk {:.2g}){}", mean,
                                     claim.reference, claim.delta, run.beta(), caveat);
    if (verdict.outcome == Outcome::refuted)
        verdict.reason = fmt::format("mean {:.9g} ± {:.2g} for {:.9g}: biased by {:+.3g} (p ≤ {:.1e}){}", mean, error,
                                     claim.reference, bias, verdict.p_value, caveat);
    return verdict;
}

Verdict mean_at_most(const Draw& draw, const AtMostClaim& claim, const Run& run) {
    if (!(claim.margin > 0)) throw std::logic_error("mean_at_most: margin must be positive");
    const Interval below{-std::numeric_limits<double>::infinity(), 0};
    auto [verdict, mean, error, bias, caveat] =
        answer(draw, question(claim, below, below, {claim.bound, claim.margin}), run);

    if (verdict.evidence.empty()) return verdict;
    if (verdict.outcome == Outcome::holds)
        verdict.reason = fmt::format("mean {:.4g} ± {:.2g}: at most {:.4g} (risk {:.2g}){}", mean, error, claim.bound,
                                     run.beta(), caveat);
    if (verdict.outcome == Outcome::refuted)
        verdict.reason = fmt::format("mean {:.4g} ± {:.2g} exceeds {:.4g} (p ≤ {:.1e}){}", mean, error, claim.bound,
                                     verdict.p_value, caveat);
    return verdict;
}

}  // namespace plumb
