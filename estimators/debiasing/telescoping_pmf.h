#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/error.h"
#include "core/random.h"

namespace plumb {

// How far a telescoping sum is followed: K = 0, 1, 2, … Each type has, side by side,
//   sample(random)  a K;
//   pmf(k)          P(K = k);
//   tail(k)         P(K ≥ k).

/// P(K ≥ k) = r^k, 0 < r < 1.
class Geometric {
public:
    explicit Geometric(double r) : r_(r) {
        if (!(r > 0 && r < 1)) throw Error(fmt::format("geometric pmf: r = {} is not in (0, 1)", r));
    }
    [[nodiscard]] std::uint64_t sample(RandomStream& random) const {
        return static_cast<std::uint64_t>(std::log1p(-random.uniform()) / std::log(r_));
    }
    [[nodiscard]] double pmf(std::uint64_t k) const { return (1 - r_) * tail(k); }
    [[nodiscard]] double tail(std::uint64_t k) const { return std::pow(r_, static_cast<double>(k)); }

private:
    double r_;
};

/// P(K ≥ k) = (k+1)^−a, a > 0: like the zeta pmf k^−(a+1) in its tail, with sampling, pmf and tail in closed form.
/// E[K] = ζ(a) − 1 for a > 1, else infinite.
class PowerLaw {
public:
    explicit PowerLaw(double a) : a_(a) {
        if (!(a > 0)) throw Error(fmt::format("power law: a = {} is not > 0", a));
    }
    /// K + 1 = ⌊U^(−1/a)⌋, U in (0, 1]; a K beyond 2^62 is given as 2^62.
    [[nodiscard]] std::uint64_t sample(RandomStream& random) const {
        const double above = std::pow(1 - random.uniform(), -1 / a_);
        return static_cast<std::uint64_t>(std::min(above, 0x1p62)) - 1;
    }
    [[nodiscard]] double pmf(std::uint64_t k) const {
        return -tail(k) * std::expm1(-a_ * std::log1p(1 / (static_cast<double>(k) + 1)));
    }
    [[nodiscard]] double tail(std::uint64_t k) const { return std::pow(static_cast<double>(k) + 1, -a_); }

private:
    double a_;
};

/// P(K = k) ∝ weights[k], k = 0 … size − 1. T is double, or a rational type for exact enumeration.
template <class T>
class FinitePmf {
public:
    explicit FinitePmf(std::vector<T> weights) : pmf_(std::move(weights)), tails_(pmf_.size() + 1, T(0)) {
        for (std::size_t k = pmf_.size(); k-- > 0;) {
            if (!(pmf_[k] >= 0)) throw Error(fmt::format("finite pmf: weight {} is negative or NaN", k));
            tails_[k] = tails_[k + 1] + pmf_[k];
        }
        const T total = tails_.front();
        if (!(total > 0) || total - total != 0)
            throw Error("finite pmf: the sum of the weights must be positive and finite");
        for (T& p : pmf_) p /= total;
        for (T& tail : tails_) tail /= total;
    }

    template <class Random>
    [[nodiscard]] std::uint64_t sample(Random& random) const {
        if constexpr (requires { random.choose(std::span<const T>(pmf_)); }) {
            return random.choose(std::span<const T>(pmf_));
        } else {
            const double u = 1 - random.uniform();  // in (0, 1]: K = k when tail(k+1) < u ≤ tail(k)
            std::uint64_t k = 0;
            while (u <= tails_[k + 1]) ++k;
            return k;
        }
    }
    [[nodiscard]] T pmf(std::uint64_t k) const { return k < pmf_.size() ? pmf_[k] : T(0); }
    [[nodiscard]] T tail(std::uint64_t k) const { return k < pmf_.size() ? tails_[k] : T(0); }

private:
    std::vector<T> pmf_, tails_;
};

/// The pmf ∝ (k+1)^−m on k = 0 … size − 1: the truncated zeta pmf, m any real number.
inline FinitePmf<double> truncated_zeta(double m, std::size_t size) {
    std::vector<double> weights(size);
    for (std::size_t k = 0; k < size; ++k) weights[k] = std::pow(static_cast<double>(k) + 1, -m);
    return FinitePmf<double>(std::move(weights));
}

}  // namespace plumb
