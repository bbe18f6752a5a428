#include "analytic/step_density.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

// The piece whose half-open interval of `borders` holds x; the last one for x at the end.
std::size_t piece_of(const std::vector<double>& borders, double x) {
    const auto above = std::upper_bound(borders.begin() + 1, borders.end() - 1, x);
    return static_cast<std::size_t>(above - borders.begin()) - 1;
}

}  // namespace

StepDensity::StepDensity(std::vector<double> edges, std::vector<double> masses)
    : edges_(std::move(edges)), masses_(std::move(masses)) {
    if (masses_.empty() || edges_.size() != masses_.size() + 1)
        throw Error(
            fmt::format("a piecewise-constant density with {} edges and {} masses; K + 1 and K ≥ 1 are accepted",
                        edges_.size(), masses_.size()));
    if (edges_.front() != 0 || edges_.back() != 1)
        throw Error(fmt::format("a piecewise-constant density from {} to {}; it must reach from 0 to 1", edges_.front(),
                                edges_.back()));
    double total = 0;
    for (std::size_t k = 0; k < masses_.size(); ++k) {
        if (!(edges_[k] < edges_[k + 1]))
            throw Error(fmt::format("edge {} is {}, not above its predecessor", k + 1, edges_[k + 1]));
        if (!(masses_[k] > 0) || std::isinf(masses_[k]))
            throw Error(fmt::format("mass {} is {}; a positive finite number is accepted", k, masses_[k]));
        total += masses_[k];
    }
    cumulative_.push_back(0);
    for (double& mass : masses_) {
        mass /= total;
        cumulative_.push_back(cumulative_.back() + mass);
    }
    cumulative_.back() = 1;
}

StepDensity StepDensity::equal_pieces(std::vector<double> masses) {
    std::vector<double> edges;
    for (std::size_t k = 0; k <= masses.size(); ++k)
        edges.push_back(static_cast<double>(k) / static_cast<double>(masses.size()));
    return {std::move(edges), std::move(masses)};
}

double StepDensity::pdf(double x) const {
    const std::size_t k = piece_of(edges_, x);
    return masses_[k] / (edges_[k + 1] - edges_[k]);
}

double StepDensity::invert(double x) const {
    const std::size_t k = piece_of(edges_, x);
    return std::min(1.0, cumulative_[k] + masses_[k] * (x - edges_[k]) / (edges_[k + 1] - edges_[k]));
}

double StepDensity::sample(double u) const {
    const std::size_t k = piece_of(cumulative_, u);
    return std::min(edges_[k + 1], edges_[k] + (edges_[k + 1] - edges_[k]) * (u - cumulative_[k]) / masses_[k]);
}

}  // namespace plumb
