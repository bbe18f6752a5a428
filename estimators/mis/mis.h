#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>
#include <vector>

#include "core/error.h"

namespace plumb {

// Weights of multiple importance sampling [Veach & Guibas 1995; Veach 1997, chapter 9]. Technique i takes n_i samples
// of density p_i; its sample x gets the weight w_i(x), and Σ_i w_i(x) = 1 wherever some n_i p_i(x) > 0. A heuristic is
// a function of r_i = n_i p_i / max_k n_k p_k in [0, 1]; the weights are its values, divided by their sum. T is double,
// or a rational type for exact weights.

/// The balance heuristic w_i ∝ n_i p_i [Veach 1997, eq. 9.8].
struct Balance {
    template <class T>
    T operator()(const T& r) const {
        return r;
    }
};

/// The power heuristic w_i ∝ (n_i p_i)^β [Veach 1997, eq. 9.13]. With a rational type β is an integer.
class Power {
public:
    explicit Power(double beta = 2) : beta_(beta) {
        if (!(beta > 0 && std::isfinite(beta))) throw Error(fmt::format("power heuristic: beta = {} is not > 0", beta));
    }

    template <class T>
    T operator()(const T& r) const {
        if constexpr (std::floating_point<T>) {
            return beta_ == 2 ? r * r : std::pow(r, beta_);
        } else {
            if (beta_ != std::floor(beta_)) throw Error(fmt::format("power heuristic: {} is no integer", beta_));
            T power = 1;
            for (int i = 0; i < beta_; ++i) power *= r;
            return power;
        }
    }

private:
    double beta_;
};

/// The maximum heuristic: all weight to the largest n_i p_i [Veach 1997, eq. 9.14]; those that share it share the
/// weight.
struct Maximum {
    template <class T>
    T operator()(const T& r) const {
        return r == 1 ? T(1) : T(0);
    }
};

/// The cutoff heuristic: the balance heuristic among those with n_i p_i ≥ α max_k n_k p_k, the others get nothing
/// [Veach 1997, eq. 9.12].
class Cutoff {
public:
    explicit Cutoff(double alpha) : alpha_(alpha) {
        if (!(alpha >= 0 && alpha <= 1))
            throw Error(fmt::format("cutoff heuristic: alpha = {} is not in [0, 1]", alpha));
    }

    template <class T>
    T operator()(const T& r) const {
        return r >= T(alpha_) ? r : T(0);
    }

private:
    double alpha_;
};

/// Sum of values ≥ 0 with the rounding errors of its additions carried along [Neumaier 1974]: within an ulp however
/// many values there are. Exact for exact types.
template <class T>
T accurate_sum(std::span<const T> values) {
    T sum = 0, carried = 0;
    for (const T& value : values) {
        const T next = sum + value;
        carried += sum >= value ? (sum - next) + value : (value - next) + sum;
        sum = next;
    }
    return sum + carried;
}

/// r_i = n_i p_i / max_k n_k p_k, without overflow for any finite n and p. Infinite densities (delta techniques) count
/// as equal to each other, and every finite one as zero beside them. All r_i are 0 where no technique could have
/// sampled. Throws Error for a NaN, a negative value or an infinite count, and names the technique.
template <class T>
std::vector<T> relative_densities(std::span<const T> counts, std::span<const T> pdfs) {
    if (counts.size() != pdfs.size())
        throw Error(fmt::format("mis: {} counts for {} pdfs", counts.size(), pdfs.size()));
    constexpr bool has_infinity = std::numeric_limits<T>::has_infinity;
    T largest = 0;
    for (std::size_t i = 0; i < pdfs.size(); ++i) {
        bool valid = counts[i] >= 0 && pdfs[i] >= 0;
        if constexpr (has_infinity) valid = valid && counts[i] < std::numeric_limits<T>::infinity();
        if (!valid) throw Error(fmt::format("mis: technique {} has a negative or invalid count or pdf", i));
        if (counts[i] > 0) largest = std::max(largest, pdfs[i]);
    }
    std::vector<T> r(pdfs.size(), T(0));
    if (largest == 0) return r;
    for (std::size_t i = 0; i < pdfs.size(); ++i)
        if (counts[i] > 0) r[i] = counts[i] * (pdfs[i] == largest ? T(1) : T(pdfs[i] / largest));
    const T top = *std::ranges::max_element(r);
    for (T& value : r) value /= top;
    return r;
}

/// w_i for every technique at one point, from the counts n_i (or, in the one-sample model, the probabilities c_i) and
/// the densities p_i there. They sum to 1, exactly in rationals and within 2 ulp in double; all are 0 where every
/// n_i p_i is.
template <class T, class Heuristic>
std::vector<T> mis_weights(const Heuristic& heuristic, std::span<const T> counts, std::span<const T> pdfs) {
    std::vector<T> weights = relative_densities(counts, pdfs);
    for (T& w : weights)
        if (w > 0) w = heuristic(w);
    const T sum = accurate_sum(std::span<const T>(weights));
    if (sum > 0)
        for (T& w : weights) w /= sum;
    return weights;
}

/// w_i(x) f(x) / (n_i p_i(x)): what a sample x of technique i adds to the multi-sample estimator
/// [Veach 1997, eq. 9.4], or, with the probabilities c_i for the counts, the value of the one-sample estimator
/// [ibid., eq. 9.15]. `pdfs` are those of all techniques at x.
template <class T, class Heuristic>
T mis_contribution(std::size_t technique, const T& f, const Heuristic& heuristic, std::span<const T> counts,
                   std::span<const T> pdfs) {
    const std::vector<T> weights = mis_weights(heuristic, counts, pdfs);
    const T& pdf = pdfs[technique];
    if (!(counts[technique] > 0 && pdf > 0) || pdf - pdf != 0)
        throw Error(fmt::format(
            "mis: a sample of technique {} where its own density is not positive and finite, or its count 0",
            technique));
    return weights[technique] * f / pdf / counts[technique];
}

}  // namespace plumb
