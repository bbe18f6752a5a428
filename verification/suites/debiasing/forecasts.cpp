// What telescoping is forecast to vary and to cost, against closed forms, measured variances and counted evaluations.

#include "verification/claim.h"
#include "verification/evidence/deterministic.h"
#include "verification/evidence/ratio.h"
#include "verification/suites/debiasing/telescoping_subjects.h"

namespace plumb::suites {
namespace {

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

/// The variance of the roulette sum of prefix products. With y = E(1 − X), s = E(1 − X)², T_k = r^k: E[Δ_j Δ_k] =
/// s^(j+1) y^(k−j) for j ≤ k, so that the sum S has E S² = (1 + y)/(1 − y) · s r/(r − s), s < r, and E S = y/(1 − y).
double reciprocal_variance() {
    const double y = 0.4, s = y * y + 0.2 * 0.2 / 12, r = reciprocal_r;
    return (1 + y) / (1 - y) * s * r / (r - s) - std::pow(y / (1 - y), 2);
}

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
    return variance_is(draw, forecast_single_term(exp_difference, nothing, one, pmf, 60).variance, 0.05, 120000, run,
                       "terms of 1/k! that come once in 2^k: those that matter come once in 100");
}

struct Forecast {
    Draw draw;
    double variance;
};

Verdict forecast_is_variance(const Forecast& forecast, const Run& run) {
    return variance_is(forecast.draw, forecast.variance, 0.05, 60000, run,
                       "terms of 1/k! that come once in 2^k: those that matter come once in 100");
}

double exp_sum_variance() {
    return forecast_roulette_sum(exp_difference, nothing, one, Geometric(0.5), 60).variance;
}

double exp_sum_variance_of_independent_terms() {
    double variance = 0;
    for (std::uint64_t k = 0; k < 60; ++k)
        variance += std::pow(exp_difference(k), 2) * (1 / Geometric(0.5).tail(k) - 1);
    return variance;
}

}  // namespace

void add_debiasing_forecasts(Catalogue& catalogue) {
    catalogue.add({
        .id = "debiasing/forecast/closed-forms",
        .statement = "Forecast variance and cost agree with their closed forms.",
        .source = "[Rhee & Glynn 2015, theorems 1 and 2]; closed forms ours",
        .kind = Kind::bounded,
        .trial = {forecasts_are_closed_forms,
                  1,
                  {{"counted-from-zero", "A roulette sum is said to evaluate K differences, not K + 1.", 0}}},
    });
    catalogue.add({
        .id = "debiasing/forecast/single-term-variance",
        .statement = "The single-term estimator has the variance Σ Δ_k²/p_k − (I − I_0)².",
        .source = "[Rhee & Glynn 2015]; ours, estimators/debiasing/telescoping.h",
        .kind = Kind::ratio,
        .trial = {[](const Draw& draw, const Run& run) { return exp_single_variance(draw, Geometric(0.5), run); },
                  exp_single_term(Geometric(0.5)),
                  {{"another-pmf", "K is drawn and weighted with r = 0.51.", exp_single_term(Geometric(0.51))}}},
    });
    catalogue.add({
        .id = "debiasing/forecast/roulette-sum-variance",
        .statement = "The roulette sum has the variance Σ (e_k² − e_{k+1}²)/P(K ≥ k) − e_0².",
        .source = "[Rhee & Glynn 2015, theorem 1]",
        .kind = Kind::ratio,
        .trial = {forecast_is_variance,
                  {exp_roulette_sum(Geometric(0.5)), exp_sum_variance()},
                  {{"another-pmf",
                    "K is drawn and weighted with r = 0.48.",
                    {exp_roulette_sum(Geometric(0.48)), exp_sum_variance()}},
                   {"independent-sum",
                    "The variance of independent terms, Σ Δ_k²/P(K ≥ k) − Σ Δ_k².",
                    {exp_roulette_sum(Geometric(0.5)), exp_sum_variance_of_independent_terms()}}}},
    });
    catalogue.add({
        .id = "debiasing/forecast/reciprocal-variance",
        .statement = "The roulette sum of prefix products has the variance (1+y)/(1−y) · s r/(r−s) − (y/(1−y))².",
        .source = "ours, verification/suites/debiasing/telescoping.cpp",
        .kind = Kind::ratio,
        .trial = {[](const Draw& draw, const Run& run) {
                      return variance_is(draw, reciprocal_variance(), 0.05, 80000, run,
                                         "products of about 0.4^k that survive with 0.55^k");
                  },
                  reciprocal,
                  {{"powers-of-one-sample", "All factors are the same sample.", reciprocal_from_powers}}},
    });
    catalogue.add({
        .id = "debiasing/forecast/cost",
        .statement = "A telescoped trapezoidal rule evaluates 2 + Σ 2^k P(K ≥ k) times on average.",
        .source = "ours, estimators/debiasing/telescoping.h",
        .kind = Kind::cost,
        .trial = {trapezoid_cost,
                  [](std::uint64_t k) { return std::ldexp(1, static_cast<int>(k)); },
                  {{"rules-not-nested", "Each refinement is said to evaluate all its 2^(k+1) + 1 points anew.",
                    [](std::uint64_t k) { return std::ldexp(2, static_cast<int>(k)) + 1; }}}},
    });
}

}  // namespace plumb::suites
