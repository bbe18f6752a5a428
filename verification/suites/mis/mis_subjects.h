#pragma once

#include <functional>
#include <numeric>
#include <span>
#include <vector>

#include "estimators/mis/mis.h"
#include "verification/verdict.h"

namespace plumb::suites {

// The claims about MIS have these subjects: the library's weights and contributions, and mutants of them, over double
// or a rational type.
//
// Weights that sum to 1 keep the mean, whatever counts they were computed from: weights from the wrong counts are no
// defect of the expectation, but of the definition and of the variance, and are mutants there. In the short form of the
// balance heuristic, f / Σ n_k p_k, the same mistake is a bias.

/// The value w f / (n_i p_i) that a sample of technique i adds, from f, the counts and the densities: the library's, or
/// a mutant's.
template <class T>
using Contribution = std::function<T(std::size_t i, const T& f, std::span<const T> counts, std::span<const T> pdfs)>;
template <class T>
using Weights = std::function<std::vector<T>(std::span<const T> counts, std::span<const T> pdfs)>;

template <class T, class Heuristic>
Contribution<T> contribution(Heuristic heuristic) {
    return [heuristic](std::size_t i, const T& f, std::span<const T> n, std::span<const T> p) {
        return mis_contribution<T>(i, f, heuristic, n, p);
    };
}
template <class T, class Heuristic>
Weights<T> weights(Heuristic heuristic) {
    return [heuristic](std::span<const T> n, std::span<const T> p) { return mis_weights<T>(heuristic, n, p); };
}

template <class T>
std::vector<Weights<T>> all_heuristics() {
    return {weights<T>(Balance{}), weights<T>(Power{}), weights<T>(Power{3}), weights<T>(Maximum{}),
            weights<T>(Cutoff{0.5})};
}

template <class Subject>
Verdict all_of_each(Verdict (*check)(const Subject&), const std::vector<Subject>& subjects) {
    std::vector<Verdict> parts;
    for (const Subject& subject : subjects) parts.push_back(check(subject));
    return all_of(std::move(parts));
}

// ---- mutants of the weights

/// The weights that divide the heuristic's values by the sum of n p instead of by their own.
template <class T, class Heuristic>
Weights<T> over_the_balance_sum(Heuristic heuristic) {
    return [heuristic](std::span<const T> n, std::span<const T> p) {
        std::vector<T> w = relative_densities<T>(n, p);
        const T sum = std::accumulate(w.begin(), w.end(), T(0));
        for (T& value : w) value = sum > 0 ? T(heuristic(value) / sum) : T(0);
        return w;
    };
}

template <class T>
Weights<T> ignoring_counts() {
    return [](std::span<const T> n, std::span<const T> p) {
        std::vector<T> ones(n.size(), T(1));
        for (std::size_t i = 0; i < n.size(); ++i)
            if (n[i] == 0) ones[i] = 0;
        return mis_weights<T>(Balance{}, ones, p);
    };
}

template <class T>
Contribution<T> with_weights(Weights<T> weights) {
    return [weights](std::size_t i, const T& f, std::span<const T> n, std::span<const T> p) {
        return T(weights(n, p)[i] * f / p[i] / n[i]);
    };
}

/// The short form f / Σ n_k p_k with the counts in the order of another list of techniques.
template <class T>
T short_form_with_reversed_counts(std::size_t, const T& f, std::span<const T> n, std::span<const T> p) {
    T sum = 0;
    for (std::size_t k = 0; k < p.size(); ++k) sum += n[n.size() - 1 - k] * p[k];
    return sum > 0 ? T(f / sum) : T(0);
}

/// One-sample values without the division by c_i.
template <class T>
T without_c(std::size_t i, const T& f, std::span<const T> c, std::span<const T> p) {
    return mis_contribution<T>(i, f, Balance{}, c, p) * c[i];
}

/// Equal weights for the techniques that can sample the point, whatever their densities.
template <class T>
Weights<T> plain_average() {
    return [](std::span<const T> n, std::span<const T> p) {
        std::vector<T> possible(n.size());
        for (std::size_t i = 0; i < n.size(); ++i) possible[i] = p[i] > 0 ? 1 : 0;
        return mis_weights<T>(Balance{}, std::vector<T>(n.size(), T(1)), possible);
    };
}

}  // namespace plumb::suites
