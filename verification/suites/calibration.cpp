// The tests on trial: what a verdict's risks really are. Each draw below is one whole simulated test.
// Rates of 1e-6 and less are reached by tilting: the test is run under a law under which the rare outcome is common,
// and the outcome is weighted with the likelihood ratio, which keeps the expectation (docs/statistics.md,
// "Calibration").

#include <boost/math/special_functions/binomial.hpp>
#include <cmath>

#include "verification/betting.h"
#include "verification/convergence.h"
#include "verification/deterministic.h"
#include "verification/distribution.h"
#include "verification/distributions.h"
#include "verification/mean.h"
#include "verification/suites/suites.h"

namespace plumb {
namespace {

using Decision = MeanTest::Decision;

constexpr double alpha_in_use = 1e-4 / 150;  // a typical share of the default budget
constexpr double beta = 0.01;
constexpr double aim = 1.3;  // a rate may exceed its level by at most this factor

// The tilt that shifts the mean by theta sigma, within an exponential family: log dP_0/dP_theta (x) = b + a x.
struct Tilt {
    double theta, a, b;
};

struct TiltedLaw {
    std::string name;
    double mean, sigma;  // at theta = 0
    Interval bounds;
    std::function<Tilt(double theta)> tilt;
    std::function<double(double theta, RandomStream&)> draw;
};

TiltedLaw bernoulli(double p) {
    const double sigma = std::sqrt(p * (1 - p));
    const auto tilted = [=](double theta) { return std::clamp(p + theta * sigma, p / 16, 1 - (1 - p) / 16); };
    const auto tilt = [=](double theta) {
        const double q = tilted(theta), b = std::log((1 - p) / (1 - q));
        return Tilt{theta, std::log(p / q) - b, b};
    };
    const auto draw = [=](double theta, RandomStream& random) { return random.uniform() < tilted(theta) ? 1.0 : 0.0; };
    return {fmt::format("Bernoulli({:g})", p), p, sigma, {0, 1}, tilt, draw};
}

TiltedLaw normal() {
    const auto draw = [](double theta, RandomStream& random) {
        const double r = std::sqrt(-2 * std::log1p(-random.uniform()));
        return theta + r * std::cos(2 * M_PI * random.uniform());
    };
    return {"normal", 0, 1, {}, [](double theta) { return Tilt{theta, -theta, theta * theta / 2}; }, draw};
}

TiltedLaw exponential() {  // of mean 1 + theta
    const auto draw = [](double theta, RandomStream& random) { return -std::log1p(-random.uniform()) * (1 + theta); };
    const auto tilt = [](double theta) { return Tilt{theta, 1 / (1 + theta) - 1, std::log1p(theta)}; };
    return {"exponential", 1, 1, {0, std::numeric_limits<double>::infinity()}, tilt, draw};
}

struct SimulatedRun {
    Decision decision = Decision::none;
    double weight = 1;  // dP_0 / dP_mixture along the samples used
};

// Runs a test on samples of the law tilted by one of `thetas`, chosen at random, until it decides or the cap is
// reached. The weight is against the mixture of all tilts (the balance heuristic), so no single tilt can spoil it.
template <class Test>
SimulatedRun simulate(Test test, const TiltedLaw& law, const std::vector<double>& thetas, std::uint64_t cap,
                      RandomStream& random) {
    const double theta = thetas[random.below(thetas.size())];
    SimulatedRun run;
    std::array<double, MeanTest::largest_block> block{};
    double sum = 0;
    while (run.decision == Decision::none && test.moments().count() < cap) {
        const auto values = std::span(block).first(test.block_size());
        for (double& x : values) {
            x = law.draw(theta, random);
            sum += x;
        }
        run.decision = test.add(values);
    }
    double inverse = 0;
    for (const double each : thetas) {
        const Tilt tilt = law.tilt(each);
        inverse += std::exp(-tilt.b * static_cast<double>(test.moments().count()) - tilt.a * sum);
    }
    run.weight = static_cast<double>(thetas.size()) / inverse;
    return run;
}

constexpr double delta_over_sigma = 0.2;
constexpr auto cap_of_a_test = static_cast<std::uint64_t>(100 / (delta_over_sigma * delta_over_sigma));

MeanTest mean_test(const TiltedLaw& law, double alpha) {
    const double delta = delta_over_sigma * law.sigma;
    return MeanTest({{law.mean, law.mean}, {law.mean - delta, law.mean + delta}, delta, law.bounds, alpha, beta, 0});
}

// Common practice: a z-test of the fixed-size kind, looked at after every block.
class PeekingZTest {
public:
    PeekingZTest(double mean, double alpha) : mean_(mean), z_(normal_upper_quantile(alpha / 2)) {}
    [[nodiscard]] std::size_t block_size() const { return 64; }
    [[nodiscard]] const Moments& moments() const { return moments_; }
    Decision add(std::span<const double> block) {
        for (const double x : block) moments_.add(x);
        return std::abs(moments_.mean() - mean_) > z_ * moments_.standard_error() ? Decision::refuted : Decision::none;
    }

private:
    double mean_, z_;
    Moments moments_;
};

// The rate of false alarms over alpha_in_use.
template <class Test>
Verdict false_alarms(const Test& test, const TiltedLaw& law, const Run& run) {
    // A bet 1 + lambda (x − m) on Bernoulli values is the likelihood ratio of the tilt theta = lambda sigma: the tilts
    // that follow the bets make the weights of refuted runs nearly equal.
    const std::vector<double> shifts = {-0.8, -0.4, -0.2, -0.1, 0.1, 0.2, 0.4, 0.8};
    const auto draw = [&](RandomStream& random) {
        const SimulatedRun simulated = simulate(test, law, shifts, cap_of_a_test, random);
        return simulated.decision == Decision::refuted ? simulated.weight / alpha_in_use : 0.0;
    };
    const Interval bounds{0, std::numeric_limits<double>::infinity()};
    return mean_at_most(draw, {.bound = aim, .margin = 0.8, .bounds = bounds, .cap = 1 << 21}, run);
}

void add_false_alarm_claim(Catalogue& catalogue, const TiltedLaw& law, const std::string& name, Sizes sizes) {
    catalogue.add(
        {.id = "calibration/false-alarms/" + name,
         .statement = fmt::format("A true mean of {} values is refuted at most {} times as often as its level, {:.1e}.",
                                  law.name, aim, alpha_in_use),
         .source = "Ville 1939; Waudby-Smith & Ramdas 2024; docs/statistics.md",
         .kind = Kind::mean,
         .check = [law](const Run& run) { return false_alarms(mean_test(law, alpha_in_use), law, run); },
         .mutants = {{"peeking", "a fixed-size z-test at this level, looked at after every 64 values",
                      [law](const Run& run) { return false_alarms(PeekingZTest(law.mean, alpha_in_use), law, run); }}},
         .sizes = sizes});
}

// How often a test at a deviation of delta ends in `holds`.
template <class Decide>
Verdict wrong_holds(const Decide& ends_in_holds, const Run& run) {
    const auto draw = [&](RandomStream& random) { return ends_in_holds(random) ? 1.0 : 0.0; };
    return mean_at_most(draw, {.bound = aim * beta, .margin = aim * beta / 2, .bounds = {0, 1}}, run);
}

bool betting_holds_at_delta(const TiltedLaw& law, RandomStream& random) {
    const double delta = delta_over_sigma * law.sigma;
    MeanTest test({{law.mean + delta, law.mean + delta},
                   {law.mean, law.mean + 2 * delta},
                   delta,
                   law.bounds,
                   alpha_in_use,
                   beta,
                   0});
    return simulate(test, law, {0.0}, cap_of_a_test, random).decision == Decision::holds;
}

// Common practice: a fixed sample, "not rejected" read as "holds".
bool fixed_test_does_not_reject_at_delta(const TiltedLaw& law, RandomStream& random) {
    Moments moments;
    for (int i = 0; i < 400; ++i) moments.add(law.draw(0, random));
    const double z = (moments.mean() - law.mean - delta_over_sigma * law.sigma) / moments.standard_error();
    return normal_two_sided_tail(z) > 0.01;
}

void add_wrong_holds_claim(Catalogue& catalogue) {
    catalogue.add(
        {.id = "calibration/wrong-holds/mean",
         .statement = "A bias of exactly delta ends in `holds` in at most 1.3 % of the runs (aim: 1 %).",
         .source = "docs/statistics.md, Mean claims",
         .kind = Kind::mean,
         .check =
             [law = exponential()](const Run& run) {
                 return wrong_holds([&](RandomStream& random) { return betting_holds_at_delta(law, random); }, run);
             },
         .mutants = {{"not-rejected", "a fixed-size test whose silence is read as `holds`",
                      [law = exponential()](const Run& run) {
                          return wrong_holds(
                              [&](RandomStream& random) { return fixed_test_does_not_reject_at_delta(law, random); },
                              run);
                      }}}});
}

// With bets of c delta/sigma², log-wealth against ±delta is nearly a Brownian motion of drift mu = c − c²/2 and
// deviation c in the time T = n (delta/sigma)², and `holds` waits until both reach b = log(1/beta): P(one has not by T)
// is the classical first-passage formula. At T = 100 it gives 5e-9; where it is large enough to be seen, it is checked.
double brownian_undecided(double T) {
    const double c = 0.75, mu = c - c * c / 2, b = -std::log(beta), root = c * std::sqrt(T);
    const auto phi = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
    return 2 * (phi((b - mu * T) / root) - std::exp(2 * mu * b / (c * c)) * phi((-b - mu * T) / root));
}

Verdict undecided_though_true(double size_of_bets, const Run& run) {
    constexpr double T = 25, ratio = 0.1;
    const TiltedLaw law = bernoulli(0.5);
    const double delta = ratio * law.sigma, predicted = brownian_undecided(T);
    const auto draw = [&](RandomStream& random) {
        MeanTest test({{law.mean, law.mean},
                       {law.mean - delta, law.mean + delta},
                       size_of_bets * delta,
                       law.bounds,
                       alpha_in_use,
                       beta,
                       0});
        return simulate(test, law, {0.0}, static_cast<std::uint64_t>(T / (ratio * ratio)), random).decision ==
                       Decision::holds
                   ? 0.0
                   : 1.0;
    };
    return mean_at_most(draw, {.bound = aim * predicted, .margin = 0.3 * predicted, .bounds = {0, 1}}, run);
}

void add_undecided_claim(Catalogue& catalogue) {
    catalogue.add({.id = "calibration/undecided/mean",
                   .statement = "The share of true means still undecided after T (sigma/delta)² samples is at most 1.3 "
                                "times that of Brownian "
                                "motion at T = 25, whose formula gives 5e-9 at T = 100.",
                   .source = "first passage of Brownian motion; docs/statistics.md, Risks and shares",
                   .kind = Kind::mean,
                   .check = [](const Run& run) { return undecided_though_true(1, run); },
                   .mutants = {{"timid", "bets of half the size",
                                [](const Run& run) { return undecided_though_true(0.5, run); }}}});
}

// x^-1/a for uniform x: tails of index a.
Draw pareto(double a) {
    return [a](RandomStream& random) { return std::pow(1 - random.uniform(), -1 / a); };
}

Verdict heavy_tails_hold(double a, bool guarded, const Run& run) {
    const double mean = a / (a - 1), delta = 0.3 * mean;
    // Bounds that the values do not have switch the guard off.
    const Interval bounds = guarded ? Interval{} : Interval{-mean, 100 * mean};
    const auto decided = [&](RandomStream& random) {
        MeanTest test({{mean, mean}, {mean - delta, mean + delta}, delta, bounds, alpha_in_use, beta, 0});
        std::array<double, MeanTest::largest_block> block{};
        auto decision = Decision::none;
        const Draw draw = pareto(a);
        while (decision == Decision::none && test.moments().count() < 4000) {
            const std::size_t size = test.block_size();
            for (std::size_t i = 0; i < size; ++i) block[i] = draw(random);
            decision = test.add(std::span(block).first(size));
        }
        return decision == Decision::holds;
    };
    return wrong_holds(decided, run);
}

void add_heavy_tail_claims(Catalogue& catalogue) {
    for (const double a : {1.5, 1.9, 2.0})
        catalogue.add(
            {.id = fmt::format("calibration/heavy-tails/pareto-{:g}", a),
             .statement = fmt::format("Tails of index {:g}{} end in `holds` in at most 1.3 % of the runs.", a,
                                      a == 2 ? " (x^-1/2)" : ""),
             .source = "docs/statistics.md, Heavy tails",
             .kind = Kind::mean,
             .check = [a](const Run& run) { return heavy_tails_hold(a, true, run); },
             .mutants = {{"unguarded", "bounds are declared that the values do not have, which switches the guard off",
                          [a](const Run& run) { return heavy_tails_hold(a, false, run); }}}});
}

// E[exp(log_evidence)] after three blocks of 16 Bernoulli samples, over all outcomes. Within a block lambda is fixed,
// so a block's number of successes is all that matters: 17³ outcomes.
double expected_evidence(double p, bool peek) {
    constexpr int block = 16;
    const auto probability = [&](int k) {
        return boost::math::binomial_coefficient<double>(block, static_cast<unsigned>(k)) * std::pow(p, k) *
               std::pow(1 - p, block - k);
    };
    const auto feed = [](MeanTest& test, int successes) {
        std::array<double, block> values{};
        std::fill_n(values.begin(), successes, 1.0);
        (void)test.add(values);
    };
    double expectation = 0;
    for (int a = 0; a <= block; ++a)
        for (int b = 0; b <= block; ++b)
            for (int c = 0; c <= block; ++c) {
                MeanTest test({{p, p}, {p - 0.1, p + 0.1}, 0.1, {0, 1}, alpha_in_use, beta, 0});
                for (const int successes : {a, b, c}) feed(test, successes);
                double evidence = test.log_evidence();
                if (peek) {  // the best of three looks instead of the last
                    MeanTest again({{p, p}, {p - 0.1, p + 0.1}, 0.1, {0, 1}, alpha_in_use, beta, 0});
                    for (const int successes : {a, b, c}) {
                        feed(again, successes);
                        evidence = std::max(evidence, again.log_evidence());
                    }
                }
                expectation += probability(a) * probability(b) * probability(c) * std::exp(evidence);
            }
    return expectation;
}

Verdict evidence_is_fair(bool peek) {
    std::vector<BoundedCase> cases;
    for (const double p : {0.5, 0.25, 0.03125})
        cases.push_back({fmt::format("p = {:g}", p), std::abs(expected_evidence(p, peek) - 1), p});
    return within_bound(cases, 1e-12, "of 1");
}

void add_fairness_claim(Catalogue& catalogue) {
    catalogue.add({.id = "calibration/evidence/fair",
                   .statement = "Under the claim the expectation of the evidence against it is 1, over all outcomes of "
                                "48 Bernoulli values.",
                   .source = "Waudby-Smith & Ramdas 2024, eq. 15; enumeration of all 17³ block outcomes",
                   .kind = Kind::bounded,
                   .check = [](const Run&) { return evidence_is_fair(false); },
                   .mutants = {{"best-look", "the largest evidence of three looks is treated as if it were the last",
                                [](const Run&) { return evidence_is_fair(true); }}}});
}

// How often the p-value of a true density lies below 1 %, for the smallest expected count that is allowed.
Verdict chi_square_false_alarms(int degrees_of_freedom, const Run& run) {
    const DistributionClaim claim{{0.25, 0.25, 0.25, 0.25}, 0.5};
    constexpr double level = 0.01;
    const auto draw = [&](RandomStream& random) {
        std::array<std::uint64_t, 4> counts{};
        for (int i = 0; i < 400; ++i) ++counts[random.bits() >> 62];
        return chi_square_verdict(counts, claim, level, beta, degrees_of_freedom).outcome == Outcome::refuted ? 1.0
                                                                                                              : 0.0;
    };
    return mean_at_most(
        draw, {.bound = run.pick(1.5, aim) * level, .margin = run.pick(0.5, 0.3) * level, .bounds = {0, 1}}, run);
}

// How often a density error of exactly delta ends in `holds`.
Verdict chi_square_wrong_holds(double error_of_density, const Run& run) {
    const double delta = 0.2;
    const DistributionClaim claim{{0.25, 0.25, 0.25, 0.25}, delta};
    const auto draw = [&](RandomStream& random) {
        std::array<std::uint64_t, 4> counts{};
        for (int i = 0; i < 1500; ++i) {  // phi = error: half the cells too likely by that fraction
            const bool low = random.uniform() < 0.5 * (1 + error_of_density);
            ++counts[(low ? 0 : 2) + random.below(2)];
        }
        return chi_square_verdict(counts, claim, alpha_in_use, beta).outcome == Outcome::holds ? 1.0 : 0.0;
    };
    const double bound = run.pick(1.5, aim) * beta;
    return mean_at_most(draw, {.bound = bound, .margin = bound - beta, .bounds = {0, 1}}, run);
}

void add_chi_square_claims(Catalogue& catalogue) {
    catalogue.add({.id = "calibration/false-alarms/chi-square",
                   .statement = "At an expected count of 100 the chi-square's p-value lies below 1 % in at most 1.5 % "
                                "of the runs (full: 1.3 %).",
                   .source = "docs/statistics.md, Distributions",
                   .kind = Kind::mean,
                   .check = [](const Run& run) { return chi_square_false_alarms(3, run); },
                   .mutants = {{"degrees-of-freedom-off-by-one", "cells − 2 degrees of freedom",
                                [](const Run& run) { return chi_square_false_alarms(2, run); }}}});
    catalogue.add(
        {.id = "calibration/wrong-holds/chi-square",
         .statement =
             "A density error phi of exactly delta ends in `holds` in 1 % of the runs: at most 1.5 % (full: 1.3 %).",
         .source = "noncentral chi-square; docs/statistics.md, Distributions",
         .kind = Kind::mean,
         .check = [](const Run& run) { return chi_square_wrong_holds(0.2, run); },
         .mutants = {{"delta-four-fifths", "a density error of 0.8 delta passed off as delta",
                      [](const Run& run) { return chi_square_wrong_holds(0.16, run); }}}});
}

// How often the 99 % interval of a slope misses the true exponent.
Verdict slope_interval_misses(double level, const Run& run) {
    constexpr std::uint64_t replicates = 200;
    const auto draw = [&](RandomStream& random) {
        std::vector<ConvergencePoint> points;
        for (const std::uint64_t n : {16u, 64u, 256u}) {
            Moments squares;  // errors uniform in ±1/n: MSE n^-2/3
            for (std::uint64_t r = 0; r < replicates; ++r) {
                const double error = (2 * random.uniform() - 1) / static_cast<double>(n);
                squares.add(error * error);
            }
            ConvergencePoint& point = points.emplace_back();
            point.n = n;
            point.mse = squares.mean();
            point.log_mse_error = squares.standard_error() / squares.mean();
        }
        return fit_slope(points, level).interval.contains(-2) ? 0.0 : 1.0;
    };
    return mean_at_most(draw, {.bound = 0.015, .margin = 0.005, .bounds = {0, 1}}, run);
}

void add_slope_claim(Catalogue& catalogue) {
    catalogue.add({.id = "calibration/coverage/slope",
                   .statement = "The 99 % interval of a slope misses the true exponent in at most 1.5 % of the runs.",
                   .source = "docs/statistics.md, Rates",
                   .kind = Kind::mean,
                   .check = [](const Run& run) { return slope_interval_misses(0.99, run); },
                   .mutants = {{"interval-95", "the 95 % interval called a 99 % one",
                                [](const Run& run) { return slope_interval_misses(0.95, run); }}}});
}

}  // namespace

void add_calibration_claims(Catalogue& catalogue) {
    add_fairness_claim(catalogue);
    add_false_alarm_claim(catalogue, bernoulli(0.5), "coin", Sizes::both);
    add_false_alarm_claim(catalogue, bernoulli(1e-3), "rare", Sizes::full_only);
    add_false_alarm_claim(catalogue, normal(), "normal", Sizes::full_only);
    add_wrong_holds_claim(catalogue);
    add_undecided_claim(catalogue);
    add_heavy_tail_claims(catalogue);
    add_chi_square_claims(catalogue);
    add_slope_claim(catalogue);
}

}  // namespace plumb
