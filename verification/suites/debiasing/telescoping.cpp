// Telescoping debiasing: the finite forms over every outcome, the infinite ones by their means on sequences with known
// limits.

#include "analytic/enumeration.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/suites/debiasing/telescoping_subjects.h"

namespace plumb::suites {
namespace {

// ---- finite telescoping, every outcome

const std::vector<Rational> sequence{3, {1, 2}, 7, {22, 7}, -2};
Rational sequence_difference(std::uint64_t k) {
    return sequence[k + 1] - sequence[k];
}

/// The pmf of all k ≥ 0, p_k = 2^−(k+1), of which only the first four are drawn.
const auto untruncated_pmf = [](const auto&, std::uint64_t k) { return Rational(1, std::uint64_t{2} << k); };

/// Both pmfs below have p_{k+1} > 0 wherever a mutant looks.
const std::vector<std::vector<Rational>> finite_pmfs{{1, 1, 1, 1}, {8, 4, 2, 1}, {1, 2, 5, 3}};

using Telescope = std::function<Rational(const FinitePmf<Rational>& pmf, Choices& random)>;

Verdict reaches_last_term(const Telescope& estimator) {
    std::uint64_t outcomes = 0;
    for (const auto& weights : finite_pmfs) {
        const FinitePmf<Rational> pmf(weights);
        const ExactMoments exact = enumerate([&](Choices& random) { return estimator(pmf, random); });
        outcomes += exact.outcomes;
        if (exact.mean != sequence.back())
            return exactly(false, outcomes, fmt::format("mean {} for {}", exact.mean.str(), sequence.back().str()));
    }
    return exactly(true, outcomes, "every mean is the last term of the sequence");
}

/// Single-term mutants may divide by zero past the end: the last difference then counts nothing.
template <class PmfOf>
Telescope single_term_with(PmfOf pmf_of) {
    return [pmf_of](const FinitePmf<Rational>& pmf, Choices& random) {
        const Distorted distorted{pmf, pmf_of, same_tail};
        const std::uint64_t k = distorted.sample(random);
        return distorted.pmf(k) > 0 ? single_term(sequence[0], sequence_difference, distorted, k) : sequence[0];
    };
}
template <class TailOf>
Telescope roulette_sum_with(TailOf tail_of) {
    return [tail_of](const FinitePmf<Rational>& pmf, Choices& random) {
        return telescope_roulette_sum(sequence[0], sequence_difference, Distorted{pmf, same_pmf, tail_of}, random);
    };
}

// ---- means

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

/// Values in [1, 1 + Σ 0.5^(k+1)/0.55^k] = [1, 6.5].
Verdict reciprocal_mean(const Draw& draw, const Run& run) {
    return mean_is(draw, {.reference = 1 / 0.6, .delta = 0.006, .bounds = {1, 6.5}}, run);
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
    return mean_is(draw,
                   {.reference = 0.25,
                    .delta = 0.01,
                    .bounds = {-std::numeric_limits<double>::infinity(), 1},
                    .why_fewer = "a level of probability 0.4^k brings 2^-k/24: those that matter come once in 1,000"},
                   run);
}

// ---- draws with a defect

/// Drawn up to k = 5, but not divided by the mass of these.
Draw halving_not_renormalised() {
    std::vector<double> weights;
    for (std::uint64_t k = 0; k < 6; ++k) weights.push_back(Geometric(0.6).pmf(k));
    const auto infinite = [](const auto&, std::uint64_t k) { return Geometric(0.6).pmf(k); };
    return halving_single_term(Distorted{FinitePmf<double>(weights), infinite, same_tail});
}

/// The density a (k+1)^−(a+1), a = 2, scaled to the first value of the pmf.
const auto density_for_pmf = [](const auto&, std::uint64_t k) {
    return 0.75 * std::pow(static_cast<double>(k) + 1, -3.0);
};
const auto large_pmf = [](const auto& pmf, std::uint64_t k) { return 1.03 * pmf.pmf(k); };

double exp_sum_of_three(RandomStream& random) {
    const Geometric pmf(0.5);
    const std::uint64_t last = std::min<std::uint64_t>(pmf.sample(random), 2);
    return roulette_sum(1.0, exp_difference, pmf, last);
}

double trapezoids_by_another_pmf(RandomStream& random) {
    std::vector<double> weights;
    for (std::uint64_t k = 0; k < refinements; ++k) weights.push_back(std::pow(2.6, -static_cast<double>(k)));
    Trapezoids rule;
    double current = rule.first();
    return roulette_sum(
        current, [&](std::uint64_t k) { return rule.difference(k, current); }, trapezoid_pmf(),
        FinitePmf<double>(std::move(weights)).sample(random));
}

void add_finite_telescoping(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/single-term/expectation",
        .statement = "The finite single-term estimator I_0 + Δ_k/p_k has the last term as its expectation.",
        .source = "[Misso et al. 2022]",
        .kind = Kind::exact,
        .trial = {reaches_last_term,
                  single_term_with(same_pmf),
                  {{"p-off-by-one", "Divided by p_{k+1}.", single_term_with(next_pmf)},
                   {"not-renormalised", "The pmf is that of an infinite sequence, cut after four terms.",
                    single_term_with(untruncated_pmf)}}},
    });
    catalogue.add({
        .id = "debiasing/roulette-sum/expectation",
        .statement = "The finite roulette sum I_0 + Σ Δ_k/P(K ≥ k) has the last term as its expectation.",
        .source = "[Rhee & Glynn 2015; Misso et al. 2022]",
        .kind = Kind::exact,
        .trial = {reaches_last_term,
                  roulette_sum_with(same_tail),
                  {{"pmf-for-tail", "Divided by P(K = k), not P(K ≥ k).", roulette_sum_with(same_pmf)},
                   {"strict-tail", "Divided by P(K > k).", roulette_sum_with(strict_tail)}}},
    });
}

void add_single_terms(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/single-term/geometric",
        .statement = "The single-term estimator of I_k = 1 − 2^-k with a geometric pmf has the mean 1.",
        .source = "[Misso et al. 2022]",
        .kind = Kind::mean,
        .trial = {halving_mean,
                  halving_single_term(Geometric(0.6)),
                  {{"p-off-by-one", "Divided by p_{k+1}.",
                    halving_single_term(Distorted{Geometric(0.6), next_pmf, same_tail})},
                   {"not-renormalised", "The pmf is drawn up to k = 5 and not divided by its mass.",
                    halving_not_renormalised()}}},
    });
    catalogue.add({
        .id = "debiasing/single-term/zero-variance",
        .statement = "With p_k proportional to Δ_k the single-term estimator is exact in every sample.",
        .source = "ours, estimators/debiasing/telescoping.h",
        .kind = Kind::mean,
        .trial = {[](const Draw& draw, const Run& run) {
                      return mean_is(draw, {.reference = 1, .epsilon = 1e-14, .zero_variance = true}, run);
                  },
                  halving_single_term(Geometric(0.5)),
                  {{"another-pmf", "r is 0.5001.", halving_single_term(Geometric(0.5001))}}},
    });
    catalogue.add({
        .id = "debiasing/single-term/power-law",
        .statement = "The single-term estimator of e from Taylor sums with a heavy-tailed pmf has the mean e.",
        .source = "[Misso et al. 2022]",
        .kind = Kind::mean,
        .trial = {exp_power_law_mean,
                  exp_single_term(PowerLaw(2)),
                  {{"density-for-pmf",
                    "p_k is taken for the density a (k+1)^-(a+1) of the continuous law, scaled to "
                    "its first value.",
                    exp_single_term(Distorted{PowerLaw(2), density_for_pmf, same_tail})},
                   {"off-by-normalisation", "The pmf is 3 % too large.",
                    exp_single_term(Distorted{PowerLaw(2), large_pmf, same_tail})}}},
    });
}

void add_roulette_sums(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/roulette-sum/exp",
        .statement = "The roulette sum over the Taylor series of e with a geometric K has the mean e.",
        .source = "[Rhee & Glynn 2015]",
        .kind = Kind::mean,
        .trial = {exp_sum_mean,
                  exp_roulette_sum(Geometric(0.5)),
                  {{"pmf-for-tail", "Divided by P(K = k), not P(K ≥ k).",
                    exp_roulette_sum(Distorted{Geometric(0.5), same_pmf, same_pmf})},
                   {"truncated", "The sum is cut after three differences.", exp_sum_of_three}}},
    });
    catalogue.add({
        .id = "debiasing/roulette-sum/trapezoid",
        .statement = "Trapezoidal rules on 1, 2, 4, … panels, telescoped, have the mean of the finest one.",
        .source = "[Misso et al. 2022], finite form",
        .kind = Kind::mean,
        .trial = {trapezoid_mean,
                  trapezoid_sum(trapezoid_pmf()),
                  {{"strict-tail", "Divided by P(K > k), but for the last.",
                    trapezoid_sum(Distorted{trapezoid_pmf(), same_pmf, strict_tail})},
                   {"another-pmf", "K is drawn by a pmf whose weights fall by 2.6, not 2.83.",
                    trapezoids_by_another_pmf}}},
    });
    catalogue.add({
        .id = "debiasing/roulette-sum/reciprocal",
        .statement = "1/E[X] is estimated without bias from prefix products of independent 1 − X_j.",
        .source = "[Booth 2007; Misso et al. 2022]",
        .kind = Kind::mean,
        .trial = {reciprocal_mean,
                  reciprocal,
                  {{"powers-of-one-sample", "All factors are the same sample: E(1 − X)^k is not (1 − E X)^k.",
                    reciprocal_from_powers}}},
    });
}

void add_squared_mean(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/single-term/squared-mean",
        .statement = "(E X)² is estimated without bias from squares of means of 2^k samples and of their halves.",
        .source = "[Rhee & Glynn 2015; Misso et al. 2022]",
        .kind = Kind::mean,
        .trial = {squared_mean_is,
                  squared_mean(Geometric(0.4)),
                  {{"p-off-by-one", "Divided by p_{k+1}.",
                    squared_mean(Distorted{Geometric(0.4), next_pmf, same_tail})},
                   {"cut-after-two", "The sequence ends at I_2 = 1/4 + 1/48.",
                    squared_mean(FinitePmf<double>({0.6, 0.4}))}}},
    });
}

}  // namespace

void add_debiasing_telescoping(Catalogue& catalogue) {
    add_finite_telescoping(catalogue);
    add_single_terms(catalogue);
    add_roulette_sums(catalogue);
    add_squared_mean(catalogue);
}

}  // namespace plumb::suites
