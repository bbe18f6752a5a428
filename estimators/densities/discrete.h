#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "core/error.h"
#include "core/random.h"

namespace plumb {

// Two samplers of a discrete pdf given by weights: P(i) = w_i / Σw. With integer weights (std::uint64_t) their law is
// exact: they draw integers, and no probability is ever rounded. Zero weights are never drawn.

/// The sum of the weights, checked: not empty, none negative, NaN or infinite, not all zero, and `factor` times the sum
/// without overflow.
template <class Weight>
Weight checked_total(std::span<const Weight> weights, std::size_t factor = 1) {
    Weight total = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if constexpr (std::floating_point<Weight>) {
            if (!(weights[i] >= 0 && std::isfinite(weights[i])))
                throw Error(fmt::format("weight {} is {}: accepted are finite numbers >= 0", i, weights[i]));
        } else if (weights[i] > std::numeric_limits<Weight>::max() / factor - total) {
            throw Error(fmt::format("the sum of the weights overflows at weight {}", i));
        }
        total += weights[i];
    }
    if (!(total > 0) ||
        (std::floating_point<Weight> && !std::isfinite(static_cast<double>(total) * static_cast<double>(factor))))
        throw Error(fmt::format("{} weights of sum {}: a positive finite sum is needed", weights.size(), total));
    return total;
}

/// A uniform number below the bound: exactly for integers, within rounding for double.
inline std::uint64_t uniform_below(std::uint64_t bound, RandomStream& random) {
    return random.below(bound);
}
inline double uniform_below(double bound, RandomStream& random) {
    return bound * random.uniform();
}

/// A discrete distribution sampled by inversion of the CDF: O(log n) a sample.
template <class Weight>
class DiscreteCdf {
public:
    explicit DiscreteCdf(std::span<const Weight> weights) : ends_(weights.size()) {
        checked_total(weights);
        std::partial_sum(weights.begin(), weights.end(), ends_.begin());
    }

    [[nodiscard]] Weight total() const { return ends_.back(); }
    /// The i with w_0 + … + w_{i−1} ≤ position < w_0 + … + w_i, for a position in [0, total).
    [[nodiscard]] std::size_t at(Weight position) const {
        const auto found = std::ranges::upper_bound(ends_, position);
        // Rounding may put a position at the total: then the last index of positive weight.
        return static_cast<std::size_t>((found != ends_.end() ? found : std::ranges::lower_bound(ends_, total())) -
                                        ends_.begin());
    }
    std::size_t sample(RandomStream& random) const { return at(uniform_below(total(), random)); }

private:
    std::vector<Weight> ends_;
};

/// One column of an alias table: the first `threshold` of `total` go to the column's own index, the rest to alias.
template <class Weight>
struct AliasColumn {
    Weight threshold;
    std::size_t alias;
};

/// n columns of equal height that hold the weights, no column more than two of them [Vose 1991]: O(1) a sample.
template <class Weight>
class AliasTable {
public:
    explicit AliasTable(std::span<const Weight> weights)
        : total_(checked_total(weights, weights.size())), columns_(weights.size()) {
        std::vector<Weight> rest(weights.begin(), weights.end());  // in units of 1/n: a column is `total` high
        std::vector<std::size_t> small, large;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            rest[i] *= static_cast<Weight>(rest.size());
            (rest[i] < total_ ? small : large).push_back(i);
        }
        while (!small.empty() && !large.empty()) {
            const std::size_t s = small.back(), l = large.back();
            small.pop_back();
            columns_[s] = {rest[s], l};
            rest[l] -= total_ - rest[s];
            if (rest[l] < total_) {
                large.pop_back();
                small.push_back(l);
            }
        }
        for (const std::size_t i : large) columns_[i] = {total_, i};
        for (const std::size_t i : small) columns_[i] = {total_, i};  // only by rounding
    }

    [[nodiscard]] Weight total() const { return total_; }
    [[nodiscard]] const std::vector<AliasColumn<Weight>>& columns() const { return columns_; }
    std::size_t sample(RandomStream& random) const {
        const std::size_t column = random.below(columns_.size());
        return uniform_below(total_, random) < columns_[column].threshold ? column : columns_[column].alias;
    }

private:
    Weight total_;
    std::vector<AliasColumn<Weight>> columns_;
};

}  // namespace plumb
