#pragma once

#include <cstdint>

#include "core/error.h"
#include "core/estimate.h"
#include "core/moments.h"
#include "core/random.h"
#include "estimators/densities/technique.h"
#include "estimators/estimator.h"

namespace plumb {

/// True with probability p. A source of randomness that can do better than compare a uniform number (one that
/// enumerates every outcome) says so by a member chance().
template <class T, class Random>
bool chance(const T& p, Random& random) {
    if constexpr (requires { random.chance(p); }) {
        return random.chance(p);
    } else {
        return random.uniform() < p;
    }
}

/// value()/q with probability q, else 0: the expectation is that of value(), which is evaluated only on survival
/// [Arvo & Kirk 1990]. q in (0, 1]; it may depend on anything known before value() is.
template <class T, class Value, class Random>
T russian_roulette(const T& q, const Value& value, Random& random) {
    if (!(q > 0 && q <= 1)) throw Error("russian roulette: the survival probability must be in (0, 1]");
    return chance(q, random) ? T(value() / q) : T(0);
}

/// The variance of russian_roulette() for a value of this mean and variance: E Z² = (σ² + μ²)/q.
template <class T>
T roulette_variance(const T& mean, const T& variance, const T& q) {
    return (variance + mean * mean) / q - mean * mean;
}

/// ∫f from n uniform samples, of which each is evaluated with probability q. Its expected cost is n q evaluations.
template <int D>
Estimate roulette(const Function<D>& f, double q, std::uint64_t n, RandomStream& random) {
    Moments values;
    Estimate estimate;
    for (std::uint64_t j = 0; j < n; ++j) {
        const Point<D> x = uniform_point<D>(random);
        values.add(russian_roulette(
            q, [&] { return ++estimate.evaluations, f(x); }, random));
    }
    estimate.value = values.mean();
    estimate.standard_error = values.standard_error();
    return estimate;
}

}  // namespace plumb
