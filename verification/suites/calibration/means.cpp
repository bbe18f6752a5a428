// The mean test on trial: what its risks really are. Each draw below is one whole simulated test.

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numbers>

#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/distributions.h"
#include "verification/evidence/mean.h"
#include "verification/suites/calibration/laws.h"

namespace plumb::suites {
namespace {

using Decision = MeanTest::Decision;

struct Trial {
    std::string name;
    TiltedLaw law;
    Sizes sizes;
};

// The laws on trial. Without bounds, skewness sets how many samples must pass before a decision: 1500 skewness².
std::vector<Trial> trials() {
    return {{"coin", bernoulli(0.5), Sizes::both},
            {"rare", bernoulli(1e-3).at(0.02), Sizes::full_only},
            {"rare-without-bounds", bernoulli(0.05).without_bounds(0.025, 320), Sizes::full_only},
            {"normal", normal(), Sizes::both},
            {"exponential", exponential().at(0.05), Sizes::full_only},
            {"exponential-without-bounds", exponential().without_bounds(0.05, 0), Sizes::full_only},
            {"lognormal", lognormal(0.5).at(0.05), Sizes::full_only},
            {"lognormal-without-bounds", lognormal(0.5).without_bounds(0.05, 0), Sizes::full_only},
            {"spikes", spikes().at(0.1), Sizes::full_only},
            {"spikes-without-bounds", spikes().without_bounds(0.02, 800), Sizes::full_only}};
}

// ---- false alarms ----

// Common practice: a z-test of the fixed-size kind, looked at after every block.
class PeekingZTest {
public:
    PeekingZTest(double mean, double alpha) : mean_(mean), z_(normal_upper_quantile(alpha / 2)) {}
    [[nodiscard]] std::size_t block_size() const { return 64; }
    [[nodiscard]] const Moments& moments() const { return moments_; }
    Decision add(std::span<const double> block) {
        moments_.merge(Moments::of(block));
        return std::abs(moments_.mean() - mean_) > z_ * moments_.standard_error() ? Decision::refuted : Decision::none;
    }

private:
    double mean_, z_;
    Moments moments_;
};

// The rate of false alarms over alpha_in_use. A bet 1 + lambda (x − m) is nearly the likelihood ratio of the tilt
// theta = lambda sigma: tilts that follow the bets, up to their largest, make the weights of refuted runs nearly equal.
// The few that exceed fifty times the level are cut there, so that the verdict on the rate is exact.
constexpr double largest_weight = 50;

using Simulation = std::function<SimulatedRun(const std::vector<double>& thetas, RandomStream& random)>;

template <class Test>
Simulation simulation_of(const Test& test, const TiltedLaw& law) {
    return [=](const std::vector<double>& thetas, RandomStream& random) {
        return simulate(test, law, thetas, law.cap(), random);
    };
}

Verdict false_alarms(const Simulation& simulation, const TiltedLaw& law, const Run& run) {
    std::vector<double> thetas;
    for (double theta = law.delta_over_sigma / 2; theta < 0.25; theta *= 2)
        thetas.insert(thetas.end(), {-theta, theta});
    thetas.insert(thetas.end(), {-0.25, 0.25});
    const auto draw = [&](RandomStream& random) {
        const SimulatedRun simulated = simulation(thetas, random);
        return simulated.refuted ? std::min(simulated.weight / alpha_in_use, largest_weight) : 0.0;
    };
    return mean_at_most(draw, {.bound = aim, .margin = 0.8, .bounds = {0, largest_weight}}, run);
}

void add_false_alarm_claim(Catalogue& catalogue, const Trial& trial) {
    const TiltedLaw law = trial.law;
    catalogue.add({.id = "calibration/false-alarms/" + trial.name,
                   .statement = fmt::format(
                       "A true mean of {} values{} is refuted at most {} times as often as its level, {:.1e}.",
                       law.name, law.bounds == Interval{} ? ", no bounds declared," : "", aim, alpha_in_use),
                   .source = "[Ville 1939; Waudby-Smith & Ramdas 2024]; docs/statistics.md",
                   .kind = Kind::mean,
                   .trial = {[law](const Simulation& test, const Run& run) { return false_alarms(test, law, run); },
                             simulation_of(law.test(law.mean), law),
                             {{"peeking", "a fixed-size z-test at this level, looked at after every 64 values",
                               simulation_of(PeekingZTest(law.mean, alpha_in_use), law)}}},
                   .sizes = trial.sizes});
}

// ---- wrong holds ----

// A test of new random numbers: whether it ends in `holds`.
using EndsInHolds = std::function<bool(RandomStream&)>;

// The verdict on how often a test at a deviation of delta ends in `holds`.
Verdict wrong_holds(const EndsInHolds& ends_in_holds, double rate, const Run& run) {
    const auto draw = [&](RandomStream& random) { return ends_in_holds(random) ? 1.0 : 0.0; };
    return mean_at_most(draw, {.bound = rate, .margin = rate / 3, .bounds = {0, 1}}, run);
}

// The claim lies below the truth by delta: the side on which spikes that were not seen could help it.
bool holds_at_delta(const TiltedLaw& law, RandomStream& random) {
    return simulate(law.test(law.mean - law.delta()), law, {0.0}, law.cap(), random).holds;
}

// Common practice: a fixed sample, "not rejected" read as "holds". With 9 (sigma/delta)² values z is 3 on average.
bool fixed_test_does_not_reject_at_delta(const TiltedLaw& law, RandomStream& random) {
    Moments moments;
    for (double i = 0; i < 9 / std::pow(law.delta_over_sigma, 2); ++i) moments.add(law.draw(0, random).x);
    const double z = (moments.mean() - law.mean + law.delta()) / moments.standard_error();
    return normal_two_sided_tail(z) > 0.01;
}

void add_wrong_holds_claim(Catalogue& catalogue, const Trial& trial) {
    const TiltedLaw law = trial.law;
    const auto check = [](const EndsInHolds& ends_in_holds, const Run& run) {
        return wrong_holds(ends_in_holds, aim * beta_in_use, run);
    };
    catalogue.add(
        {.id = "calibration/wrong-holds/" + trial.name,
         .statement = fmt::format("A bias of exactly delta of {} values{} ends in `holds` in at most 1.3 % of the runs "
                                  "(aim: 1 %).",
                                  law.name, law.bounds == Interval{} ? ", no bounds declared," : ""),
         .source = "docs/statistics.md, Mean claims",
         .kind = Kind::mean,
         .trial = {check,
                   [law](RandomStream& random) { return holds_at_delta(law, random); },
                   {{"not-rejected", "a fixed-size test of 9 (sigma/delta)² values whose silence is read as `holds`",
                     [law](RandomStream& random) { return fixed_test_does_not_reject_at_delta(law, random); }}}},
         .sizes = trial.sizes});
}

// ---- undecided though true ----

// With bets of c delta/sigma², log-wealth against ±delta is nearly a Brownian motion of drift mu = c − c²/2 and
// deviation c in the time T = n (delta/sigma)², and `holds` waits until both reach b = log(1/beta): P(one has not by T)
// is the classical first-passage formula. At T = 100 it gives 5e-9; where it is large enough to be seen, it is checked.
double brownian_undecided(double T) {
    const double c = 0.75, mu = c - c * c / 2, b = -std::log(beta_in_use), root = c * std::sqrt(T);
    const auto phi = [](double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); };
    return 2 * (phi((b - mu * T) / root) - std::exp(2 * mu * b / (c * c)) * phi((-b - mu * T) / root));
}

Verdict undecided_though_true(double size_of_bets, const Run& run) {
    constexpr double T = 25, ratio = 0.1;
    const TiltedLaw law = bernoulli(0.5);
    const double delta = ratio * law.sigma, predicted = brownian_undecided(T);
    const auto draw = [&](RandomStream& random) {
        const MeanTest test({{law.mean, law.mean},
                             {law.mean - delta, law.mean + delta},
                             size_of_bets * delta,
                             law.bounds,
                             alpha_in_use,
                             beta_in_use,
                             0});
        const auto cap = static_cast<std::uint64_t>(T / (ratio * ratio));
        return simulate(test, law, {0.0}, cap, random).holds ? 0.0 : 1.0;
    };
    return mean_at_most(draw, {.bound = aim * predicted, .margin = 0.3 * predicted, .bounds = {0, 1}}, run);
}

// Values that are 1 with a small probability p and else 0, range R = 1: the bet against "too large" is at most 1/(2R)
// and loses log 2 at each 1, so that it waits for n large enough in units of R/delta, however small the variance.
// P(undecided) ≤ P(the bet's log-wealth at n is below log(1/beta)), a binomial tail, for the variance known.
double rare_undecided(double p, double delta, double n) {
    const double m = p + delta, lambda = std::min(0.5 / (1 - m), 0.75 * delta / (p * (1 - p)));
    const double gain = std::log1p(lambda * m), loss = gain - std::log1p(-lambda * (1 - m));
    const double too_many = (n * gain + std::log(beta_in_use)) / loss;
    return too_many < 0 ? 1 : cdf(complement(boost::math::binomial(n, p), std::floor(too_many)));
}

Verdict rare_values_are_decided(double per_range) {
    std::vector<BoundedCase> cases;
    for (const double p : {1e-2, 1e-4, 1e-6})
        for (const double ratio : {0.01, 0.1, 0.3, 0.5, 1.0, 1.5, 2.0, 3.0, 10.0}) {  // of p to delta
            const double delta = p / ratio, n = std::max(100 * p * (1 - p) / (delta * delta), per_range / delta);
            if (p + delta < 0.5)
                cases.push_back({fmt::format("p = {:g}, delta = {:.3g}", p, delta),
                                 rare_undecided(p, delta, std::floor(n)), ratio});
        }
    return within_bound(cases, 1e-5, "probability");
}

void add_undecided_claims(Catalogue& catalogue) {
    catalogue.add({.id = "calibration/undecided/mean",
                   .statement = "The share of true means still undecided after T (sigma/delta)² samples is at most 1.3 "
                                "times that of Brownian motion at T = 25, whose formula gives 5e-9 at T = 100.",
                   .source = "first passage of Brownian motion; docs/statistics.md, Risks and shares",
                   .kind = Kind::mean,
                   .trial = {undecided_though_true, 1, {{"timid", "bets of half the size", 0.5}}}});
    catalogue.add(
        {.id = "calibration/undecided/rare",
         .statement = "A cap of max(100 sigma²/delta², 400 (hi − lo)/delta) leaves at most 1e-5 of true means "
                      "of rare values undecided.",
         .source = "binomial tails; docs/statistics.md, Risks and shares",
         .kind = Kind::bounded,
         .trial = {
             rare_values_are_decided, 400, {{"variance-alone", "a cap of 100 sigma²/delta² whatever the range", 0}}}});
}

// ---- heavy tails ----

// x^-1/a for uniform x: tails of index a. Bounds that the values do not have switch the guard off.
Verdict heavy_tails_hold(double a, bool guarded, const Run& run) {
    const double mean = a / (a - 1), delta = 0.3 * mean;
    const Interval bounds = guarded ? Interval{} : Interval{-mean, 100 * mean};
    const auto cap = run.pick<std::uint64_t>(4000, 40000);
    const auto ends_in_holds = [&](RandomStream& random) {
        MeanTest test({{mean, mean}, {mean - delta, mean + delta}, delta, bounds, alpha_in_use, beta_in_use, 0});
        std::array<double, MeanTest::largest_block> block{};
        auto decision = Decision::none;
        while (decision == Decision::none && test.moments().count() < cap) {
            const auto values = std::span(block).first(test.block_size());
            for (double& x : values) x = std::pow(1 - random.uniform(), -1 / a);
            decision = test.add(values);
        }
        return decision == Decision::holds;
    };
    return wrong_holds(ends_in_holds, 0.01, run);
}

void add_heavy_tail_claims(Catalogue& catalogue) {
    for (const double a : {1.5, 1.9, 2.0})
        catalogue.add(
            {.id = fmt::format("calibration/heavy-tails/pareto-{:g}", a),
             .statement = fmt::format("Tails of index {:g}{} end in `holds` in at most 1 % of the runs.", a,
                                      a == 2 ? " (x^-1/2)" : ""),
             .source = "docs/statistics.md, Heavy tails",
             .kind = Kind::mean,
             .trial = {[a](bool guarded, const Run& run) { return heavy_tails_hold(a, guarded, run); },
                       true,
                       {{"unguarded", "bounds are declared that the values do not have, which switches the guard off",
                         false}}}});
}

// ---- the evidence itself ----

// E[exp(log_evidence)] after three blocks of 16 Bernoulli samples, over all outcomes. Within a block lambda is fixed,
// so a block's number of successes is all that matters: 17³ outcomes.
double expected_evidence(double p, bool peek) {
    constexpr int block = 16;
    const boost::math::binomial successes_in_block(block, p);
    double expectation = 0;
    for (int a = 0; a <= block; ++a)
        for (int b = 0; b <= block; ++b)
            for (int c = 0; c <= block; ++c) {
                MeanTest test({{p, p}, {p - 0.1, p + 0.1}, 0.1, {0, 1}, alpha_in_use, beta_in_use, 0});
                double best = 0;
                for (const int successes : {a, b, c}) {
                    std::array<double, block> values{};
                    std::fill_n(values.begin(), successes, 1.0);
                    (void)test.add(values);
                    best = std::max(best, test.log_evidence());
                }
                expectation += pdf(successes_in_block, a) * pdf(successes_in_block, b) * pdf(successes_in_block, c) *
                               std::exp(peek ? best : test.log_evidence());
            }
    return expectation;
}

Verdict evidence_is_fair(bool peek) {
    std::vector<BoundedCase> cases;
    for (const double p : {0.5, 0.25, 0.03125, 0.001})
        cases.push_back({fmt::format("p = {:g}", p), std::abs(expected_evidence(p, peek) - 1), p});
    return within_bound(cases, 1e-12, "of 1");
}

// P(p ≤ u) ≤ u for the betting p-value of 1000 tosses of a fair coin, whatever the looks.
Verdict p_value_is_valid(double inflated, const Run& run) {
    constexpr double u = 0.05;
    const TiltedLaw law = bernoulli(0.5);
    const auto draw = [&](RandomStream& random) {
        MeanTest test = law.test(law.mean);
        std::array<double, 16> block{};
        for (int i = 0; i < 60; ++i) {
            for (double& x : block) x = law.draw(0, random).x;
            (void)test.add(block);
        }
        return test.p_value() / inflated <= u ? 1.0 : 0.0;
    };
    return mean_at_most(draw, {.bound = u, .margin = u / 3, .bounds = {0, 1}}, run);
}

void add_evidence_claims(Catalogue& catalogue) {
    catalogue.add(
        {.id = "calibration/evidence/fair",
         .statement = "Under the claim the expectation of the evidence against it is 1, over all outcomes of "
                      "48 Bernoulli values.",
         .source = "[Waudby-Smith & Ramdas 2024, eq. 15]; enumeration of all 17³ block outcomes",
         .kind = Kind::bounded,
         .trial = {evidence_is_fair,
                   false,
                   {{"best-look", "the largest evidence of three looks is treated as if it were the last", true}}}});
    catalogue.add(
        {.id = "calibration/p-values/mean",
         .statement = "The p-value of a true mean after sixty looks is at most 5 % in at most 5 % of the runs.",
         .source = "[Ville 1939]",
         .kind = Kind::mean,
         .trial = {p_value_is_valid, 1, {{"overstated", "the evidence overstated five-fold", 5}}}});
}

}  // namespace

void add_calibration_means(Catalogue& catalogue) {
    add_evidence_claims(catalogue);
    for (const Trial& trial : trials()) add_false_alarm_claim(catalogue, trial);
    for (const Trial& trial : trials()) add_wrong_holds_claim(catalogue, trial);
    add_undecided_claims(catalogue);
    add_heavy_tail_claims(catalogue);
}

}  // namespace plumb::suites
