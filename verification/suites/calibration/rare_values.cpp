// Values that a sample never met, on trial: what a claim without bounds rests on.

#include <cmath>

#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/mean.h"
#include "verification/evidence/ratio.h"
#include "verification/suites/calibration/laws.h"

namespace plumb::suites {
namespace {

// A uniform value, brighter by `height` with the probability p. Verdicts that come before the first spike are those on
// the law without spikes, and each is as likely as n values are to lack them: (1 − p)^n.
struct Rare {
    double p, height;

    [[nodiscard]] double mean() const { return 0.5 + p * height; }
    [[nodiscard]] double variance() const { return 1.0 / 12 + p * (1 - p) * height * height; }
};

double uniform(RandomStream& random) {
    return random.uniform();
}

// Why fewer values do than without a reason: empty is the test as shipped.
struct Reason {
    std::string why_fewer;
};

using Question = std::function<Verdict(const Reason&, const Run&)>;

// A verdict of this outcome comes when spikes can be missing with at most the probability `level`: over it, the largest
// of a few runs, which differ little.
Verdict comes_in_time(const Question& question, Outcome outcome, double level, const Rare& law, const Reason& reason,
                      const Run& run) {
    std::vector<BoundedCase> cases;
    for (int i = 0; i < run.pick(2, 16); ++i) {
        const std::string name = fmt::format("run {}", i);
        const Verdict verdict = question(reason, run.part(name, alpha_in_use / run.alpha()));
        const double missing = std::exp(static_cast<double>(verdict.samples) * std::log1p(-law.p));
        cases.push_back({name, verdict.outcome == outcome ? missing / level : 0, static_cast<double>(i)});
    }
    return within_bound(cases, aim, "times the level");
}

Question mean_of(double reference, double delta) {
    return [=](const Reason& reason, const Run& run) {
        return mean_is(uniform, {.reference = reference, .delta = delta, .why_fewer = reason.why_fewer}, run);
    };
}

Question variance_of(double variance) {
    return [=](const Reason& reason, const Run& run) {
        return variance_is(uniform, variance, 0.1, 10000, run, reason.why_fewer);
    };
}

struct Case {
    std::string id, statement;
    Question question;
    Outcome outcome;
    Rare law;
};

void add(Catalogue& catalogue, const Case& c) {
    const double level = c.outcome == Outcome::refuted ? alpha_in_use : beta_in_use;
    catalogue.add({.id = "calibration/rare-values/" + c.id,
                   .statement = c.statement,
                   .source = "docs/statistics.md, Values that were never seen",
                   .kind = Kind::bounded,
                   .trial = {[=](const Reason& reason, const Run& run) {
                                 return comes_in_time(c.question, c.outcome, level, c.law, reason, run);
                             },
                             Reason{},
                             {{"no-guard", "No least number of values, and a refutation is not tried again.",
                               Reason{"said to be none"}}}}});
}

}  // namespace

void add_calibration_rare_values(Catalogue& catalogue) {
    const Rare spikes{1e-4, 1000}, bright{3e-5, 30}, faint{1e-4, 10};
    add(catalogue, {"mean-refuted",
                    "A true mean, a sixth of which comes from one value in 10,000, no bounds declared, is refuted "
                    "before that is met at most as often as its level.",
                    mean_of(spikes.mean(), 0.05), Outcome::refuted, spikes});
    add(catalogue, {"mean-holds",
                    "A mean that is wrong by delta, all of it in one value in 10,000, no bounds declared, holds before "
                    "that is met in at most 1 % of the runs.",
                    mean_of(0.5, spikes.mean() - 0.5), Outcome::holds, spikes});
    add(catalogue, {"variance-refuted",
                    "A true variance, a quarter of which comes from one value in 33,333, is refuted before that is met "
                    "at most as often as its level.",
                    variance_of(bright.variance()), Outcome::refuted, bright});
    add(catalogue, {"variance-holds",
                    "A variance that is wrong by 11 %, all of it in one value in 10,000, holds within 10 % before that "
                    "is met in at most 1 % of the runs.",
                    variance_of(1.0 / 12), Outcome::holds, faint});
}

}  // namespace plumb::suites
