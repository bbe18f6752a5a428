#include "estimators/reweighting/piecewise_strata.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.h"
#include "estimators/reweighting/reweighting_1d.h"
#include "estimators/reweighting/samples_1d.h"

namespace plumb {

std::vector<std::uint64_t> stratum_counts(const StepDensity& density, std::uint64_t n) {
    const std::size_t pieces = density.pieces();
    std::vector<std::uint64_t> counts(pieces);
    std::vector<double> remainders(pieces);
    for (std::size_t k = 0; k < pieces; ++k) {
        const double share = density.masses()[k] * static_cast<double>(n);
        counts[k] = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(share));
        remainders[k] = share - static_cast<double>(counts[k]);
    }
    std::vector<std::size_t> order(pieces);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return remainders[a] > remainders[b]; });
    const std::uint64_t given = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    for (std::size_t i = 0; i < pieces && given + i < n; ++i) ++counts[order[i]];
    return counts;
}

Estimate piecewise_strata_estimate(const Function<1>& f, const StepDensity& density,
                                   std::span<const std::uint64_t> counts, RandomStream& random) {
    if (counts.size() != density.pieces())
        throw Error(fmt::format("{} sample counts for {} pieces; one each is needed", counts.size(), density.pieces()));
    Estimate estimate;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k] == 0) throw Error(fmt::format("piece {} has 0 samples; at least 1 is needed", k));
        const double from = density.edges()[k], width = density.edges()[k + 1] - from;
        const std::vector<double> samples = independent_samples_1d(counts[k], random);
        const std::vector<double> weights = reweighted_weights_1d(samples);
        for (std::size_t i = 0; i < samples.size(); ++i)
            estimate.value += width * weights[i] * f({from + width * samples[i]});
        estimate.evaluations += counts[k];
    }
    return estimate;
}

}  // namespace plumb
