#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/estimate.h"
#include "core/moments.h"
#include "estimators/densities/discrete.h"
#include "estimators/densities/technique.h"
#include "estimators/estimator.h"
#include "estimators/mis/mis.h"

namespace plumb {

/// The densities of all techniques at x.
template <int D>
std::vector<double> pdfs_at(const Point<D>& x, std::span<const Technique<D>> techniques) {
    std::vector<double> pdfs;
    for (const Technique<D>& technique : techniques) pdfs.push_back(technique.pdf(x));
    return pdfs;
}

/// Multi-sample MIS: counts[i] samples of technique i, and the sum of their contributions [Veach 1997, eq. 9.4].
/// Unbiased when every point with f ≠ 0 can be sampled by a technique of positive count. The standard error is
/// infinite when a technique in use takes one sample only.
template <int D, class Heuristic>
Estimate mis_multi_sample(const Function<D>& f, std::span<const Technique<D>> techniques,
                          std::span<const std::uint64_t> counts, const Heuristic& heuristic, RandomStream& random) {
    const std::vector<double> n(counts.begin(), counts.end());
    Estimate estimate;
    double variance = 0;
    for (std::size_t i = 0; i < techniques.size(); ++i) {
        Moments values;
        for (std::uint64_t j = 0; j < counts[i]; ++j) {
            const Point<D> x = techniques[i].sample(uniform_point<D>(random));
            values.add(n[i] * mis_contribution<double>(i, f(x), heuristic, n, pdfs_at<D>(x, techniques)));
        }
        if (counts[i] == 0) continue;
        estimate.value += values.mean();
        estimate.evaluations += counts[i];
        variance += values.variance() / n[i];
    }
    if (estimate.evaluations > 0) estimate.standard_error = std::sqrt(variance);
    return estimate;
}

/// One-sample MIS, n independent times: technique i with probability c_i, one sample x of it, and
/// w_i(x) f(x) / (c_i p_i(x)) [Veach 1997, eq. 9.15]. The probabilities are normalised to sum 1.
template <int D, class Heuristic>
Estimate mis_one_sample(const Function<D>& f, std::span<const Technique<D>> techniques,
                        std::span<const double> probabilities, const Heuristic& heuristic, std::uint64_t n,
                        RandomStream& random) {
    const DiscreteCdf<double> choice(probabilities);
    std::vector<double> c(probabilities.begin(), probabilities.end());
    for (double& probability : c) probability /= choice.total();
    Moments values;
    for (std::uint64_t j = 0; j < n; ++j) {
        const std::size_t i = choice.sample(random);
        const Point<D> x = techniques[i].sample(uniform_point<D>(random));
        values.add(mis_contribution<double>(i, f(x), heuristic, c, pdfs_at<D>(x, techniques)));
    }
    return {values.mean(), values.standard_error(), n};
}

}  // namespace plumb
