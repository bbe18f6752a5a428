#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "estimators/densities/discrete.h"

namespace plumb {

/// The density on [0,1] that is constant on each of n equal cells: a discrete pdf, and uniform within the cell.
/// sample, pdf and invert as in density.h; the CDF is stored, and all three read the same numbers.
class PiecewiseConstant {
public:
    explicit PiecewiseConstant(std::span<const double> weights) : cdf_(weights.size() + 1) {
        const double total = checked_total(weights);
        for (std::size_t i = 0; i < weights.size(); ++i) cdf_[i + 1] = cdf_[i] + weights[i] / total;
        for (double& c : cdf_) c = std::min(1.0, c / cdf_.back());
    }

    [[nodiscard]] double sample(double u) const {
        const std::size_t i = cell_of(u);
        return std::min(1.0, (static_cast<double>(i) + (u - cdf_[i]) / (cdf_[i + 1] - cdf_[i])) / cells());
    }
    [[nodiscard]] double pdf(double x) const {
        if (!(0 <= x && x <= 1)) return 0;
        const std::size_t i = cell_at(x);
        return (cdf_[i + 1] - cdf_[i]) * cells();
    }
    [[nodiscard]] double invert(double x) const {
        x = std::clamp(x, 0.0, 1.0);
        const std::size_t i = cell_at(x);
        return cdf_[i] + (cdf_[i + 1] - cdf_[i]) * (x * cells() - static_cast<double>(i));
    }

private:
    [[nodiscard]] double cells() const { return static_cast<double>(cdf_.size() - 1); }
    [[nodiscard]] std::size_t cell_at(double x) const {
        return std::min(static_cast<std::size_t>(x * cells()), cdf_.size() - 2);
    }
    /// The cell of positive probability with cdf_i ≤ u < cdf_{i+1}; u = 1 belongs to the last of them.
    [[nodiscard]] std::size_t cell_of(double u) const {
        auto above = std::ranges::upper_bound(cdf_, u);
        if (above == cdf_.end()) above = std::ranges::lower_bound(cdf_, cdf_.back());
        return static_cast<std::size_t>(above - cdf_.begin()) - 1;
    }

    std::vector<double> cdf_;  // at the ends of the cells, 0 … 1
};

}  // namespace plumb
