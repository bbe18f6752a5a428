#pragma once

#include <cmath>

#include "estimators/debiasing/telescoping.h"
#include "verification/evidence/mean.h"

namespace plumb::suites {

// The claims about telescoping have these subjects: sequences with known limits, their estimators, and distorted pmfs.

/// A pmf whose answers a mutant distorts; it draws as the true one does.
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

inline const auto same_pmf = [](const auto& pmf, std::uint64_t k) { return pmf.pmf(k); };
inline const auto same_tail = [](const auto& pmf, std::uint64_t k) { return pmf.tail(k); };
inline const auto next_pmf = [](const auto& pmf, std::uint64_t k) { return pmf.pmf(k + 1); };
/// The tail P(K > k), except for the last k of a finite pmf.
inline const auto strict_tail = [](const auto& pmf, std::uint64_t k) {
    return pmf.tail(k + 1) > 0 ? pmf.tail(k + 1) : pmf.tail(k);
};

// ---- sequences with known limits

/// The differences of I_k = 1 − 2^−k → 1.
inline double halving_difference(std::uint64_t k) {
    return std::ldexp(0.5, -static_cast<int>(k));
}
/// The differences of the partial sums of e = Σ 1/k!, from I_0 = 1.
inline double exp_difference(std::uint64_t k) {
    return 1 / std::tgamma(static_cast<double>(k) + 2);
}
inline double nothing(std::uint64_t) {
    return 0;
}
inline double one(std::uint64_t) {
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

/// The integral ∫x² by the trapezoidal rule on 2^k panels, 1/3 + 4^−k/6, debiased to 64 panels.
struct Trapezoids {
    std::uint64_t evaluations = 0;
    double square(double x) { return ++evaluations, x * x; }
    double first() { return (square(0) + square(1)) / 2; }
    /// The difference I_{k+1} − I_k = (M_k − I_k)/2, with M_k the midpoint rule on the 2^k panels of I_k.
    double difference(std::uint64_t k, double& current) {
        const double panels = std::ldexp(1, static_cast<int>(k));
        double midpoints = 0;
        for (double i = 0; i < panels; ++i) midpoints += square((i + 0.5) / panels) / panels;
        const double step = (midpoints - current) / 2;
        current += step;
        return step;
    }
};
inline constexpr std::uint64_t refinements = 6;
inline FinitePmf<double> trapezoid_pmf() {  // ∝ 2^(−3k/2): the best for errors 4^−k at costs 2^k
    std::vector<double> weights;
    for (std::uint64_t k = 0; k < refinements; ++k) weights.push_back(std::exp2(-1.5 * static_cast<double>(k)));
    return FinitePmf<double>(std::move(weights));
}

/// The series 1/x = Σ (1 − x)^k with x known only as the mean of X: (1 − x)^k is estimated by a product of k
/// independent 1 − X_j, the prefixes of one sequence. Here 1 − X is uniform on (0.3, 0.5), so that x = 0.6.
inline constexpr double reciprocal_r = 0.55;
inline double one_minus_x(RandomStream& random) {
    return 0.3 + 0.2 * random.uniform();
}
inline double reciprocal(RandomStream& random) {
    double product = 1;
    return telescope_roulette_sum(
        1.0, [&](std::uint64_t) { return product *= one_minus_x(random); }, Geometric(reciprocal_r), random);
}
inline double reciprocal_from_powers(RandomStream& random) {
    const double y = one_minus_x(random);
    double product = 1;
    return telescope_roulette_sum(
        1.0, [&](std::uint64_t) { return product *= y; }, Geometric(reciprocal_r), random);
}

}  // namespace plumb::suites
