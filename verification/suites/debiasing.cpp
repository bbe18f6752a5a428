// Russian roulette and telescoping debiasing: expectations over every outcome, means, predicted variance and cost.

#include <cmath>

#include "analytic/enumeration.h"
#include "estimators/russian_roulette.h"
#include "estimators/telescoping.h"
#include "verification/deterministic.h"
#include "verification/mean.h"
#include "verification/ratio.h"
#include "verification/suites/suites.h"

namespace plumb {
namespace {

std::string fraction(const Rational& value) {
    return value.str();
}

// ---- Russian roulette

/// What a survivor counts, given its value and q; `survives` with q.
template <class T>
using Reweighting = std::function<T(const T& value, const T& q)>;
template <class T>
T not_reweighted(const T& value, const T&) {
    return value;
}
/// A path whose next vertex has half the survival probability: divided by that one's q.
template <class T>
T with_next_q(const T& value, const T& q) {
    return value / (q / 2);
}

/// The library's roulette (empty reweighting), or a mutant's.
template <class T, class Value, class Random>
T roulette_value(const Reweighting<T>& reweighting, const T& q, const Value& value, Random& random) {
    if (!reweighting) return russian_roulette(q, value, random);
    return chance(q, random) ? reweighting(value(), q) : T(0);
}

/// A value of 1 or 5 with equal chances (mean 3, variance 4) through two roulettes, one inside the other.
Verdict roulette_enumerated(const Reweighting<Rational>& reweighting) {
    std::uint64_t outcomes = 0;
    for (const Rational& q : {Rational(1, 10), Rational(1, 2), Rational(2, 3), Rational(1)}) {
        const ExactMoments exact = enumerate([&](Choices& random) {
            const auto value = [&] { return random.chance({1, 2}) ? Rational(1) : Rational(5); };
            const auto inner = [&] { return roulette_value<Rational>(reweighting, {1, 3}, value, random); };
            return roulette_value<Rational>(reweighting, q, inner, random);
        });
        outcomes += exact.outcomes;
        const Rational variance = roulette_variance<Rational>(3, roulette_variance<Rational>(3, 4, {1, 3}), q);
        if (exact.mean != 3 || exact.variance != variance)
            return exactly(false, outcomes,
                           fmt::format("q = {}: mean {} for 3, variance {} for {}", fraction(q), fraction(exact.mean),
                                       fraction(exact.variance), fraction(variance)));
    }
    return exactly(true, outcomes, "mean and variance are as predicted for every q");
}

constexpr double survival = 0.3;

/// exp(U), mean e − 1, through one roulette.
Draw rouletted_exp(Reweighting<double> reweighting) {
    return [reweighting](RandomStream& random) {
        const double u = random.uniform();
        return roulette_value(
            reweighting, survival, [u] { return std::exp(u); }, random);
    };
}

Verdict roulette_mean(const Reweighting<double>& reweighting, const Run& run) {
    return mean_is(rouletted_exp(reweighting),
                   {.reference = std::exp(1) - 1, .delta = 0.02, .bounds = {0, std::exp(1) / survival}}, run);
}

Verdict roulette_variance_is(const Reweighting<double>& reweighting, const Run& run) {
    const double e = std::exp(1);
    const double plain = (e * e - 1) / 2 - (e - 1) * (e - 1);
    return variance_is(rouletted_exp(reweighting), roulette_variance(e - 1, plain, survival), 0.05, 30000, run);
}

/// How often the integrand is evaluated in 10 trials.
Verdict roulette_cost(double q, const Run& run) {
    const Draw count = [q](RandomStream& random) {
        return static_cast<double>(roulette<1>([](const Point<1>& x) { return x[0]; }, q, 10, random).evaluations);
    };
    return mean_is(count, {.reference = 10 * survival, .delta = 0.05, .bounds = {0, 10}}, run);
}

// ---- finite telescoping, every outcome

const std::vector<Rational> sequence{3, {1, 2}, 7, {22, 7}, -2};
Rational sequence_difference(std::uint64_t k) {
    return sequence[k + 1] - sequence[k];
}

/// A pmf whose answers a mutant distorts; it draws as the true one.
template <class Pmf, class PmfOf, class TailOf>
struct Distorted {
    Pmf right;
    PmfOf pmf_of;
    TailOf tail_of;
    auto sample(auto& random) const { return right.sample(random); }
    auto pmf(std::uint64_t k) const { return pmf_of(right, k); }
    auto tail(std::uint64_t k) const { return tail_of(right, k); }
};
template <class Pmf, class PmfOf, class TailOf>
Distorted(Pmf, PmfOf, TailOf) -> Distorted<Pmf, PmfOf, TailOf>;

const auto same_pmf = [](const auto& pmf, std::uint64_t k) { return pmf.pmf(k); };
const auto same_tail = [](const auto& pmf, std::uint64_t k) { return pmf.tail(k); };
const auto next_pmf = [](const auto& pmf, std::uint64_t k) { return pmf.pmf(k + 1); };
const auto next_tail = [](const auto& pmf, std::uint64_t k) { return pmf.tail(k + 1); };
/// The pmf of all k ≥ 0, p_k = 2^−(k+1), of which only the first four are drawn.
const auto untruncated_pmf = [](const auto&, std::uint64_t k) { return Rational(1, std::uint64_t{2} << k); };

/// Both pmfs below have p_{k+1} > 0 wherever a mutant looks.
const std::vector<std::vector<Rational>> finite_pmfs{{1, 1, 1, 1}, {8, 4, 2, 1}, {1, 2, 5, 3}};

template <class Estimator>
Verdict reaches_last_term(const Estimator& estimator) {
    std::uint64_t outcomes = 0;
    for (const auto& weights : finite_pmfs) {
        const FinitePmf<Rational> pmf(weights);
        const ExactMoments exact = enumerate([&](Choices& random) { return estimator(pmf, random); });
        outcomes += exact.outcomes;
        if (exact.mean != sequence.back())
            return exactly(false, outcomes,
                           fmt::format("mean {} for {}", fraction(exact.mean), fraction(sequence.back())));
    }
    return exactly(true, outcomes, "every mean is the last term of the sequence");
}

/// Single-term mutants may divide by zero past the end: the last difference then counts nothing.
template <class PmfOf>
auto single_term_with(PmfOf pmf_of) {
    return [pmf_of](const FinitePmf<Rational>& pmf, Choices& random) {
        const Distorted distorted{pmf, pmf_of, same_tail};
        const std::uint64_t k = distorted.sample(random);
        return distorted.pmf(k) > 0 ? single_term(sequence[0], sequence_difference, distorted, k) : sequence[0];
    };
}
template <class TailOf>
auto roulette_sum_with(TailOf tail_of) {
    return [tail_of](const FinitePmf<Rational>& pmf, Choices& random) {
        return telescope_roulette_sum(sequence[0], sequence_difference, Distorted{pmf, same_pmf, tail_of}, random);
    };
}

// ---- sequences with known limits

/// I_k = 1 − 2^−k → 1.
double halving_difference(std::uint64_t k) {
    return std::ldexp(0.5, -static_cast<int>(k));
}
/// The partial sums of e = Σ 1/k!, from I_0 = 1.
double exp_difference(std::uint64_t k) {
    return 1 / std::tgamma(static_cast<double>(k) + 2);
}
double nothing(std::uint64_t) {
    return 0;
}
double one(std::uint64_t) {
    return 1;
}

template <class Pmf>
Draw halving_single_term(const Pmf& pmf) {
    return [pmf](RandomStream& random) { return telescope_single_term(0.0, halving_difference, pmf, random); };
}
template <class Pmf>
Draw exp_single_term(const Pmf& pmf) {
    return [pmf](RandomStream& random) { return telescope_single_term(1.0, exp_difference, pmf, random); };
}
template <class Pmf>
Draw exp_roulette_sum(const Pmf& pmf) {
    return [pmf](RandomStream& random) { return telescope_roulette_sum(1.0, exp_difference, pmf, random); };
}

/// r = 0.6: values 2^−(K+1) / (0.4 · 0.6^K) ≤ 1.25.
Verdict halving_mean(const Draw& draw, const Run& run) {
    return mean_is(draw, {.reference = 1, .delta = 0.01, .bounds = {0, 1.25}}, run);
}
/// a = 2: the largest value is that of k = 1, 1 + (1/2) / (1/4 − 1/9) = 4.6.
Verdict exp_power_law_mean(const Draw& draw, const Run& run) {
    return mean_is(draw, {.reference = std::exp(1), .delta = 0.02, .bounds = {1, 4.6}}, run);
}
/// r = 1/2: values from 1 + 1 to 1 + Σ_k 2^k/(k+1)! = 1 + (e² − 1)/2.
Verdict exp_sum_mean(const Draw& draw, const Run& run) {
    return mean_is(draw, {.reference = std::exp(1), .delta = 0.02, .bounds = {1, 1 + (std::exp(2) - 1) / 2}}, run);
}

/// ∫x² by the trapezoidal rule on 2^k panels, 1/3 + 4^−k/6, debiased to 64 panels.
struct Trapezoids {
    std::uint64_t evaluations = 0;
    double square(double x) { return ++evaluations, x * x; }
    double first() { return (square(0) + square(1)) / 2; }
    /// I_{k+1} − I_k = (M_k − I_k)/2, with M_k the midpoint rule on the 2^k panels of I_k.
    double difference(std::uint64_t k, double& current) {
        const double panels = std::ldexp(1, static_cast<int>(k));
        double midpoints = 0;
        for (double i = 0; i < panels; ++i) midpoints += square((i + 0.5) / panels) / panels;
        const double step = (midpoints - current) / 2;
        current += step;
        return step;
    }
};
constexpr std::uint64_t refinements = 6;
FinitePmf<double> trapezoid_pmf() {  // ∝ 2^(−3k/2): the best for errors 4^−k at costs 2^k
    std::vector<double> weights;
    for (std::uint64_t k = 0; k < refinements; ++k) weights.push_back(std::exp2(-1.5 * static_cast<double>(k)));
    return FinitePmf<double>(std::move(weights));
}

template <class Pmf>
Draw trapezoid_sum(const Pmf& pmf) {
    return [pmf](RandomStream& random) {
        Trapezoids rule;
        double current = rule.first();
        return telescope_roulette_sum(
            current, [&](std::uint64_t k) { return rule.difference(k, current); }, pmf, random);
    };
}

/// e_k² − e_{k+1}² and all differences are known: values lie in [I_0 − Σ |Δ_k|/P(K ≥ k), I_0].
Verdict trapezoid_mean(const Draw& draw, const Run& run) {
    const FinitePmf<double> pmf = trapezoid_pmf();
    double largest = 0;
    for (std::uint64_t k = 0; k < refinements; ++k)
        largest += std::exp2(-2.0 * static_cast<double>(k)) / 8 / pmf.tail(k);
    const double reference = 1.0 / 3 + std::exp2(-2.0 * refinements) / 6;
    return mean_is(draw, {.reference = reference, .delta = 2e-3, .bounds = {0.5 - largest, 0.5}}, run);
}

/// Evaluations counted for every K, weighted with its probability, against 2 + Σ 2^k P(K ≥ k).
Verdict trapezoid_cost(double (*cost_of_difference)(std::uint64_t)) {
    const FinitePmf<double> pmf = trapezoid_pmf();
    double counted = 0;
    for (std::uint64_t k = 0; k < refinements; ++k) {
        Trapezoids rule;
        double current = rule.first();
        roulette_sum(
            current, [&](std::uint64_t j) { return rule.difference(j, current); }, pmf, k);
        counted += static_cast<double>(rule.evaluations) * pmf.pmf(k);
    }
    const double forecast = 2 + forecast_roulette_sum(nothing, nothing, cost_of_difference, pmf, refinements).cost;
    return cost_is(counted, {forecast * (1 - 1e-14), forecast * (1 + 1e-14)}, "evaluations expected");
}

/// 1/x = Σ (1 − x)^k with x known only as the mean of X: (1 − x)^k is estimated by a product of k independent
/// 1 − X_j, the prefixes of one sequence. Here 1 − X is uniform on (0.3, 0.5): x = 0.6.
constexpr double reciprocal_r = 0.55;
double one_minus_x(RandomStream& random) {
    return 0.3 + 0.2 * random.uniform();
}
double reciprocal(RandomStream& random) {
    double product = 1;
    return telescope_roulette_sum(
        1.0, [&](std::uint64_t) { return product *= one_minus_x(random); }, Geometric(reciprocal_r), random);
}
double reciprocal_from_powers(RandomStream& random) {
    const double y = one_minus_x(random);
    double product = 1;
    return telescope_roulette_sum(
        1.0, [&](std::uint64_t) { return product *= y; }, Geometric(reciprocal_r), random);
}
/// Values in [1, 1 + Σ 0.5^(k+1)/0.55^k] = [1, 6.5].
Verdict reciprocal_mean(const Draw& draw, const Run& run) {
    return mean_is(draw, {.reference = 1 / 0.6, .delta = 0.006, .bounds = {1, 6.5}}, run);
}
/// With y = E(1 − X), s = E(1 − X)², T_k = r^k: E[Δ_j Δ_k] = s^(j+1) y^(k−j) for j ≤ k, so that the sum S has
/// E S² = (1 + y)/(1 − y) · s r/(r − s), s < r, and E S = y/(1 − y).
double reciprocal_variance() {
    const double y = 0.4, s = y * y + 0.2 * 0.2 / 12, r = reciprocal_r;
    return (1 + y) / (1 - y) * s * r / (r - s) - std::pow(y / (1 - y), 2);
}

/// (E X)² for X uniform on (0,1), from I_k = E(mean of 2^k samples)² = 1/4 + 2^−k/12. The difference comes from one
/// set of 2^(k+1) samples and its two halves a and b: ((a + b)/2)² − (a² + b²)/2 = −(a − b)²/4.
template <class Pmf>
Draw squared_mean(const Pmf& pmf) {
    return [pmf](RandomStream& random) {
        const double x = random.uniform();
        const auto difference = [&](std::uint64_t k) {
            const std::uint64_t half = std::uint64_t{1} << k;
            double a_minus_b = 0;
            for (std::uint64_t i = 0; i < half; ++i) a_minus_b += random.uniform() - random.uniform();
            a_minus_b /= static_cast<double>(half);
            return -a_minus_b * a_minus_b / 4;
        };
        return telescope_single_term(x * x, difference, pmf, random);
    };
}
Verdict squared_mean_is(const Draw& draw, const Run& run) {
    return mean_is(draw, {.reference = 0.25, .delta = 0.01, .bounds = {-std::numeric_limits<double>::infinity(), 1}},
                   run);
}

// ---- forecasts against closed forms

/// Single term: Σ Δ_k²/p_k = r / ((1 − r)(4r − 1)) for the halving sequence, and r/(1−r) (I_0(2/√r) − 1) for e
/// (I_0 the Bessel function). Sum: 3/4 Σ (1/(4r))^k = 3r/(4r − 1) for the halving sequence.
Verdict forecasts_are_closed_forms(double first_index) {
    std::vector<BoundedCase> errors;
    const auto compare = [&](std::string name, double found, double truth, double x) {
        errors.push_back({std::move(name), std::abs(found / truth - 1), x});
    };
    for (const double r : {0.3, 0.6, 0.8}) {
        const Geometric pmf(r);
        const double e = std::exp(1);
        compare(fmt::format("halving, single term, r = {}", r),
                forecast_single_term(halving_difference, nothing, one, pmf, 400).variance,
                r / ((1 - r) * (4 * r - 1)) - 1, r);
        compare(fmt::format("halving, roulette sum, r = {}", r),
                forecast_roulette_sum(halving_difference, nothing, one, pmf, 400).variance, 3 * r / (4 * r - 1) - 1, r);
        compare(fmt::format("exp, single term, r = {}", r),
                forecast_single_term(exp_difference, nothing, one, pmf, 60).variance,
                r / (1 - r) * (std::cyl_bessel_i(0, 2 / std::sqrt(r)) - 1) - (e - 1) * (e - 1), r);
        compare(fmt::format("differences of a roulette sum, r = {}", r),
                forecast_roulette_sum(nothing, nothing, one, pmf, 400).cost, first_index + r / (1 - r), r);
    }
    return within_bound(errors, 1e-12, "relative");
}

template <class Pmf>
Verdict exp_single_variance(const Draw& draw, const Pmf& pmf, const Run& run) {
    return variance_is(draw, forecast_single_term(exp_difference, nothing, one, pmf, 60).variance, 0.05, 60000, run);
}

void add_roulette(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/roulette/expectation",
        .statement =
            "Nested Russian roulettes keep the mean and have the variance (σ² + μ²)/q − μ², over every outcome.",
        .source = "Arvo & Kirk 1990; variance ours, estimators/russian_roulette.h",
        .kind = Kind::exact,
        .check = [](const Run&) { return roulette_enumerated({}); },
        .mutants = {{"not-reweighted", "Survivors are not divided by q.",
                     [](const Run&) { return roulette_enumerated(not_reweighted<Rational>); }},
                    {"next-q", "Survivors are divided by the survival probability of the next vertex.",
                     [](const Run&) { return roulette_enumerated(with_next_q<Rational>); }}},
    });
    catalogue.add({
        .id = "debiasing/roulette/mean",
        .statement = "Russian roulette keeps the mean.",
        .source = "Arvo & Kirk 1990",
        .kind = Kind::mean,
        .check = [](const Run& run) { return roulette_mean({}, run); },
        .mutants = {{"not-reweighted", "Survivors are not divided by q.",
                     [](const Run& run) { return roulette_mean(not_reweighted<double>, run); }},
                    {"rounded-q", "Survivors are divided by 0.31, the probability of another table's row.",
                     [](const Run& run) {
                         return roulette_mean([](double value, double q) { return value / (q + 0.01); }, run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/roulette/variance",
        .statement = "The variance of roulette is (σ² + μ²)/q − μ².",
        .source = "ours, estimators/russian_roulette.h",
        .kind = Kind::ratio,
        .check = [](const Run& run) { return roulette_variance_is({}, run); },
        .mutants = {{"next-q", "Survivors are divided by the survival probability of the next vertex.",
                     [](const Run& run) { return roulette_variance_is(with_next_q<double>, run); }},
                    {"rounded-q", "Survivors are divided by 0.32, not 0.3.",
                     [](const Run& run) {
                         return roulette_variance_is([](double value, double q) { return value / (q + 0.02); }, run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/roulette/cost",
        .statement = "Roulette with q evaluates n q times on average.",
        .source = "ours, estimators/russian_roulette.h",
        .kind = Kind::mean,
        .check = [](const Run& run) { return roulette_cost(survival, run); },
        .mutants = {{"other-q", "q is 0.315, not 0.3.", [](const Run& run) { return roulette_cost(0.315, run); }}},
    });
}

void add_finite_telescoping(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/single-term/expectation",
        .statement = "The finite single-term estimator I_0 + Δ_k/p_k has the last term as its expectation.",
        .source = "Misso et al. 2022",
        .kind = Kind::exact,
        .check = [](const Run&) { return reaches_last_term(single_term_with(same_pmf)); },
        .mutants = {{"p-off-by-one", "Divided by p_{k+1}.",
                     [](const Run&) { return reaches_last_term(single_term_with(next_pmf)); }},
                    {"not-renormalised", "The pmf is that of an infinite sequence, cut after four terms.",
                     [](const Run&) { return reaches_last_term(single_term_with(untruncated_pmf)); }}},
    });
    catalogue.add({
        .id = "debiasing/roulette-sum/expectation",
        .statement = "The finite roulette sum I_0 + Σ Δ_k/P(K ≥ k) has the last term as its expectation.",
        .source = "Rhee & Glynn 2015; Misso et al. 2022",
        .kind = Kind::exact,
        .check = [](const Run&) { return reaches_last_term(roulette_sum_with(same_tail)); },
        .mutants = {{"pmf-for-tail", "Divided by P(K = k), not P(K ≥ k).",
                     [](const Run&) { return reaches_last_term(roulette_sum_with(same_pmf)); }},
                    {"strict-tail", "Divided by P(K > k).",
                     [](const Run&) {
                         return reaches_last_term(roulette_sum_with([](const auto& pmf, std::uint64_t k) {
                             return pmf.tail(k + 1) > 0 ? pmf.tail(k + 1) : pmf.tail(k);
                         }));
                     }}},
    });
}

void add_infinite_telescoping(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/single-term/geometric",
        .statement = "The single-term estimator of I_k = 1 − 2^-k with a geometric pmf has the mean 1.",
        .source = "Misso et al. 2022",
        .kind = Kind::mean,
        .check = [](const Run& run) { return halving_mean(halving_single_term(Geometric(0.6)), run); },
        .mutants = {{"p-off-by-one", "Divided by p_{k+1}.",
                     [](const Run& run) {
                         return halving_mean(halving_single_term(Distorted{Geometric(0.6), next_pmf, same_tail}), run);
                     }},
                    {"not-renormalised", "The pmf is drawn up to k = 5 and not divided by its mass.",
                     [](const Run& run) {
                         std::vector<double> weights;
                         for (std::uint64_t k = 0; k < 6; ++k) weights.push_back(Geometric(0.6).pmf(k));
                         const auto infinite = [](const auto&, std::uint64_t k) { return Geometric(0.6).pmf(k); };
                         return halving_mean(
                             halving_single_term(Distorted{FinitePmf<double>(weights), infinite, same_tail}), run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/single-term/zero-variance",
        .statement = "With p_k proportional to Δ_k the single-term estimator is exact in every sample.",
        .source = "ours, estimators/telescoping.h",
        .kind = Kind::mean,
        .check =
            [](const Run& run) {
                return mean_is(halving_single_term(Geometric(0.5)),
                               {.reference = 1, .epsilon = 1e-14, .zero_variance = true}, run);
            },
        .mutants = {{"another-pmf", "r is 0.5001.",
                     [](const Run& run) {
                         return mean_is(halving_single_term(Geometric(0.5001)),
                                        {.reference = 1, .epsilon = 1e-14, .zero_variance = true}, run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/single-term/power-law",
        .statement = "The single-term estimator of e from Taylor sums with a heavy-tailed pmf has the mean e.",
        .source = "Misso et al. 2022",
        .kind = Kind::mean,
        .check = [](const Run& run) { return exp_power_law_mean(exp_single_term(PowerLaw(2)), run); },
        .mutants = {{"density-for-pmf",
                     "p_k is taken for the density a (k+1)^-(a+1) of the continuous law, scaled to "
                     "its first value.",
                     [](const Run& run) {
                         const auto density = [](const auto&, std::uint64_t k) {
                             return 0.75 * std::pow(static_cast<double>(k) + 1, -3.0);
                         };
                         return exp_power_law_mean(exp_single_term(Distorted{PowerLaw(2), density, same_tail}), run);
                     }},
                    {"off-by-normalisation", "The pmf is 3 % too large.",
                     [](const Run& run) {
                         const auto large = [](const auto& pmf, std::uint64_t k) { return 1.03 * pmf.pmf(k); };
                         return exp_power_law_mean(exp_single_term(Distorted{PowerLaw(2), large, same_tail}), run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/roulette-sum/exp",
        .statement = "The roulette sum over the Taylor series of e with a geometric K has the mean e.",
        .source = "Rhee & Glynn 2015",
        .kind = Kind::mean,
        .check = [](const Run& run) { return exp_sum_mean(exp_roulette_sum(Geometric(0.5)), run); },
        .mutants = {{"pmf-for-tail", "Divided by P(K = k), not P(K ≥ k).",
                     [](const Run& run) {
                         return exp_sum_mean(exp_roulette_sum(Distorted{Geometric(0.5), same_pmf, same_pmf}), run);
                     }},
                    {"truncated", "The sum is cut after three differences.",
                     [](const Run& run) {
                         const Draw truncated = [](RandomStream& random) {
                             const Geometric pmf(0.5);
                             const std::uint64_t last = std::min<std::uint64_t>(pmf.sample(random), 2);
                             return roulette_sum(1.0, exp_difference, pmf, last);
                         };
                         return exp_sum_mean(truncated, run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/roulette-sum/trapezoid",
        .statement = "Trapezoidal rules on 1, 2, 4, … panels, telescoped, have the mean of the finest one.",
        .source = "Misso et al. 2022, finite form",
        .kind = Kind::mean,
        .check = [](const Run& run) { return trapezoid_mean(trapezoid_sum(trapezoid_pmf()), run); },
        .mutants = {{"strict-tail", "Divided by P(K > k), but for the last.",
                     [](const Run& run) {
                         const auto strict = [](const auto& pmf, std::uint64_t k) {
                             return pmf.tail(k + 1) > 0 ? pmf.tail(k + 1) : pmf.tail(k);
                         };
                         return trapezoid_mean(trapezoid_sum(Distorted{trapezoid_pmf(), same_pmf, strict}), run);
                     }},
                    {"another-pmf", "K is drawn by a pmf whose weights fall by 2.6, not 2.83.",
                     [](const Run& run) {
                         const Draw other = [](RandomStream& random) {
                             std::vector<double> weights;
                             for (std::uint64_t k = 0; k < refinements; ++k)
                                 weights.push_back(std::pow(2.6, -static_cast<double>(k)));
                             Trapezoids rule;
                             double current = rule.first();
                             return roulette_sum(
                                 current, [&](std::uint64_t k) { return rule.difference(k, current); }, trapezoid_pmf(),
                                 FinitePmf<double>(std::move(weights)).sample(random));
                         };
                         return trapezoid_mean(other, run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/roulette-sum/reciprocal",
        .statement = "1/E[X] is estimated without bias from prefix products of independent 1 − X_j.",
        .source = "Booth 2007; Misso et al. 2022",
        .kind = Kind::mean,
        .check = [](const Run& run) { return reciprocal_mean(reciprocal, run); },
        .mutants = {{"powers-of-one-sample", "All factors are the same sample: E(1 − X)^k is not (1 − E X)^k.",
                     [](const Run& run) { return reciprocal_mean(reciprocal_from_powers, run); }}},
    });
    catalogue.add({
        .id = "debiasing/single-term/squared-mean",
        .statement = "(E X)² is estimated without bias from squares of means of 2^k samples and of their halves.",
        .source = "Rhee & Glynn 2015; Misso et al. 2022",
        .kind = Kind::mean,
        .check = [](const Run& run) { return squared_mean_is(squared_mean(Geometric(0.4)), run); },
        .mutants = {{"p-off-by-one", "Divided by p_{k+1}.",
                     [](const Run& run) {
                         return squared_mean_is(squared_mean(Distorted{Geometric(0.4), next_pmf, same_tail}), run);
                     }},
                    {"cut-after-two", "The sequence ends at I_2 = 1/4 + 1/48.",
                     [](const Run& run) {
                         return squared_mean_is(squared_mean(FinitePmf<double>({0.6, 0.4})), run);
                     }}},
    });
}

void add_forecasts(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/forecast/closed-forms",
        .statement = "Forecast variance and cost agree with their closed forms.",
        .source = "Rhee & Glynn 2015, theorems 1 and 2; closed forms ours",
        .kind = Kind::bounded,
        .check = [](const Run&) { return forecasts_are_closed_forms(1); },
        .mutants = {{"counted-from-zero", "A roulette sum is said to evaluate K differences, not K + 1.",
                     [](const Run&) { return forecasts_are_closed_forms(0); }}},
    });
    catalogue.add({
        .id = "debiasing/forecast/single-term-variance",
        .statement = "The single-term estimator has the variance Σ Δ_k²/p_k − (I − I_0)².",
        .source = "Rhee & Glynn 2015; ours, estimators/telescoping.h",
        .kind = Kind::ratio,
        .check =
            [](const Run& run) { return exp_single_variance(exp_single_term(Geometric(0.5)), Geometric(0.5), run); },
        .mutants = {{"another-pmf", "K is drawn and weighted with r = 0.51.",
                     [](const Run& run) {
                         return exp_single_variance(exp_single_term(Geometric(0.51)), Geometric(0.5), run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/forecast/roulette-sum-variance",
        .statement = "The roulette sum has the variance Σ (e_k² − e_{k+1}²)/P(K ≥ k) − e_0².",
        .source = "Rhee & Glynn 2015, theorem 1",
        .kind = Kind::ratio,
        .check =
            [](const Run& run) {
                const double forecast =
                    forecast_roulette_sum(exp_difference, nothing, one, Geometric(0.5), 60).variance;
                return variance_is(exp_roulette_sum(Geometric(0.5)), forecast, 0.05, 60000, run);
            },
        .mutants = {{"another-pmf", "K is drawn and weighted with r = 0.48.",
                     [](const Run& run) {
                         const double forecast =
                             forecast_roulette_sum(exp_difference, nothing, one, Geometric(0.5), 60).variance;
                         return variance_is(exp_roulette_sum(Geometric(0.48)), forecast, 0.05, 60000, run);
                     }},
                    {"independent-sum", "The variance of independent terms, Σ Δ_k²/P(K ≥ k) − Σ Δ_k².",
                     [](const Run& run) {
                         double independent = 0;
                         for (std::uint64_t k = 0; k < 60; ++k)
                             independent += std::pow(exp_difference(k), 2) * (1 / Geometric(0.5).tail(k) - 1);
                         return variance_is(exp_roulette_sum(Geometric(0.5)), independent, 0.05, 60000, run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/forecast/reciprocal-variance",
        .statement = "The roulette sum of prefix products has the variance (1+y)/(1−y) · s r/(r−s) − (y/(1−y))².",
        .source = "ours, verification/suites/debiasing.cpp",
        .kind = Kind::ratio,
        .check = [](const Run& run) { return variance_is(reciprocal, reciprocal_variance(), 0.05, 80000, run); },
        .mutants = {{"powers-of-one-sample", "All factors are the same sample.",
                     [](const Run& run) {
                         return variance_is(reciprocal_from_powers, reciprocal_variance(), 0.05, 80000, run);
                     }}},
    });
    catalogue.add({
        .id = "debiasing/forecast/cost",
        .statement = "A telescoped trapezoidal rule evaluates 2 + Σ 2^k P(K ≥ k) times on average.",
        .source = "ours, estimators/telescoping.h",
        .kind = Kind::cost,
        .check =
            [](const Run&) {
                return trapezoid_cost([](std::uint64_t k) { return std::ldexp(1, static_cast<int>(k)); });
            },
        .mutants = {{"rules-not-nested", "Each refinement is said to evaluate all its 2^(k+1) + 1 points anew.",
                     [](const Run&) {
                         return trapezoid_cost([](std::uint64_t k) { return std::ldexp(2, static_cast<int>(k)) + 1; });
                     }}},
    });
}

}  // namespace

void add_debiasing_claims(Catalogue& catalogue) {
    add_roulette(catalogue);
    add_finite_telescoping(catalogue);
    add_infinite_telescoping(catalogue);
    add_forecasts(catalogue);
}

}  // namespace plumb
