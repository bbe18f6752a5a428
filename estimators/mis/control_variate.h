#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/error.h"
#include "core/estimate.h"
#include "core/moments.h"
#include "estimators/densities/technique.h"
#include "estimators/estimator.h"

namespace plumb {

/// A function whose integral over the unit cube is known.
template <int D>
struct ControlVariate {
    Function<D> value;
    double integral = 0;
};

/// The mean of f − β (g − ∫g) over n uniform samples: unbiased for every fixed β, of least variance at
/// β = Cov(f, g)/Var(g). Counts evaluations of f.
template <int D>
Estimate control_variate(const Function<D>& f, const ControlVariate<D>& g, double beta, std::uint64_t n,
                         RandomStream& random) {
    Moments values;
    for (std::uint64_t j = 0; j < n; ++j) {
        const Point<D> x = uniform_point<D>(random);
        values.add(f(x) - beta * (g.value(x) - g.integral));
    }
    return {values.mean(), values.standard_error(), n};
}

/// One evaluated sample: f and g at the same point. T is double, or a rational type for exact enumeration.
template <class T>
struct Pair {
    T f, g;
};

/// Cov(f, g)/Var(g) over the samples that `kept(i)` admits, about their own means; 0 when g does not vary among them.
template <class T, class Kept>
T fitted_coefficient(const std::vector<Pair<T>>& samples, Kept kept) {
    T n = 0, mean_f = 0, mean_g = 0, covariance = 0, variance = 0;  // [Welford 1962], for the covariance too
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!kept(i)) continue;
        n += 1;
        const T df = samples[i].f - mean_f, dg = samples[i].g - mean_g;
        mean_f += df / n;
        mean_g += dg / n;
        covariance += df * (samples[i].g - mean_g);
        variance += dg * (samples[i].g - mean_g);
    }
    return variance > 0 ? T(covariance / variance) : T(0);
}

/// f_i − β_k (g_i − ∫g) for every sample i, with β_k fitted on all samples outside its fold k = i mod folds. β_k is
/// independent of the samples of fold k, so every value has the expectation ∫f, exactly and for every n ≥ 1.
template <class T>
std::vector<T> cross_fitted_values(const std::vector<Pair<T>>& samples, const T& integral_g, std::size_t folds) {
    if (folds < 2) throw Error(fmt::format("cross-fitting with {} folds: at least 2 are needed", folds));
    std::vector<T> values(samples.size());
    for (std::size_t fold = 0; fold < std::min(folds, samples.size()); ++fold) {
        const T beta = fitted_coefficient(samples, [&](std::size_t i) { return i % folds != fold; });
        for (std::size_t i = fold; i < samples.size(); i += folds)
            values[i] = samples[i].f - beta * (samples[i].g - integral_g);
    }
    return values;
}

/// Control variate with the coefficient estimated from the samples themselves and still unbiased, by cross-fitting.
/// The values of different folds are uncorrelated only to O(1/n): the standard error is asymptotic.
template <int D>
Estimate control_variate_fitted(const Function<D>& f, const ControlVariate<D>& g, std::uint64_t n, RandomStream& random,
                                std::size_t folds = 4) {
    std::vector<Pair<double>> samples(n);
    for (Pair<double>& sample : samples) {
        const Point<D> x = uniform_point<D>(random);
        sample = {f(x), g.value(x)};
    }
    Moments values;
    for (const double value : cross_fitted_values(samples, g.integral, folds)) values.add(value);
    return {values.mean(), values.standard_error(), n};
}

}  // namespace plumb
