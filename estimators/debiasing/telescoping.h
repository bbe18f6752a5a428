#pragma once

#include <cstdint>

#include "estimators/debiasing/telescoping_pmf.h"

namespace plumb {

// Debiasing by a telescoping sum [Misso et al. 2022; Rhee & Glynn 2015]. A sequence I_0, I_1, … → I of biased answers
// is written as I = I_0 + Σ_k Δ_k with Δ_k = I_{k+1} − I_k, and the sum is estimated with a random index K:
//
//   single term    I_0 + Δ_K / p_K, with p_k = P(K = k)
//   roulette sum   I_0 + Σ_{k ≤ K} Δ_k / P(K ≥ k)
//
// Both have the expectation I when Σ E|Δ_k| < ∞ and P(K = k) > 0 wherever Δ_k ≠ 0; a finite
// pmf on k < m debiases to I_m. The terms may be random: `difference(k)` is then an estimate of I_{k+1} − I_k, best of
// both with common random numbers. The roulette sum asks for differences 0, 1, …, K in this order, so that a caller
// may keep prefix products or nested samples.
//
// Variance, for deterministic sequences [Rhee & Glynn 2015, theorems 1 and 2], with e_k = I − I_k:
//
//   single term    Σ_k Δ_k² / P(K = k) − e_0²
//   roulette sum   Σ_k (e_k² − e_{k+1}²) / P(K ≥ k) − e_0²
//
// Independent noise of variance v_k in difference k adds Σ v_k / P(K = k), or Σ v_k / P(K ≥ k). With costs c_k of the
// differences the expected cost is Σ c_k P(K = k), or Σ c_k P(K ≥ k), beside that of I_0.

/// The single-term estimator, given K = k.
template <class T, class Difference, class Pmf>
T single_term(const T& first, Difference&& difference, const Pmf& pmf, std::uint64_t k) {
    return first + difference(k) / pmf.pmf(k);
}

/// The roulette-sum estimator, given K = k.
template <class T, class Difference, class Pmf>
T roulette_sum(T first, Difference&& difference, const Pmf& pmf, std::uint64_t k) {
    for (std::uint64_t j = 0; j <= k; ++j) first += difference(j) / pmf.tail(j);
    return first;
}

/// I_0 + Δ_K / P(K): one random difference.
template <class T, class Difference, class Pmf, class Random>
T telescope_single_term(const T& first, Difference&& difference, const Pmf& pmf, Random& random) {
    return single_term(first, difference, pmf, pmf.sample(random));
}

/// I_0 + Σ_{k ≤ K} Δ_k / P(K ≥ k): all differences up to a random one.
template <class T, class Difference, class Pmf, class Random>
T telescope_roulette_sum(const T& first, Difference&& difference, const Pmf& pmf, Random& random) {
    return roulette_sum(first, difference, pmf, pmf.sample(random));
}

/// What to expect of an estimator before running it.
struct TelescopingForecast {
    double variance = 0;  ///< of one estimate
    double cost = 0;      ///< expected, of the differences, in the unit in which they are given
};

/// The forecast for the single-term estimator of a sequence whose differences have the means Δ_k, the variances v_k
/// (independent of each other and of K) and the costs c_k, summed over k < terms: what follows must be negligible.
template <class Mean, class Variance, class Cost, class Pmf>
TelescopingForecast forecast_single_term(Mean&& delta, Variance&& v, Cost&& c, const Pmf& pmf, std::uint64_t terms) {
    TelescopingForecast forecast;
    double error = 0;  // e_0 = Σ Δ_k
    for (std::uint64_t k = 0; k < terms; ++k) {
        forecast.variance += (delta(k) * delta(k) + v(k)) / pmf.pmf(k);
        forecast.cost += c(k) * pmf.pmf(k);
        error += delta(k);
    }
    forecast.variance -= error * error;
    return forecast;
}

/// The same for the roulette sum; e_k² − e_{k+1}² = Δ_k (Δ_k + 2 e_{k+1}).
template <class Mean, class Variance, class Cost, class Pmf>
TelescopingForecast forecast_roulette_sum(Mean&& delta, Variance&& v, Cost&& c, const Pmf& pmf, std::uint64_t terms) {
    TelescopingForecast forecast;
    double error = 0;  // e_{k+1}, from the last term back
    for (std::uint64_t k = terms; k-- > 0;) {
        forecast.variance += (delta(k) * (delta(k) + 2 * error) + v(k)) / pmf.tail(k);
        forecast.cost += c(k) * pmf.tail(k);
        error += delta(k);
    }
    forecast.variance -= error * error;
    return forecast;
}

}  // namespace plumb
