#include "estimators/reweighting/chebyshev_patch.h"

#include <cmath>
#include <numbers>

namespace plumb {
namespace {

/// The weights with which the values at the nodes make up the interpolant at u.
std::vector<double> barycentric(const std::vector<double>& nodes, double u) {
    std::vector<double> weights(nodes.size());
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (u == nodes[i]) {
            std::ranges::fill(weights, 0.0);
            weights[i] = 1;
            return weights;
        }
        weights[i] = (i % 2 ? -1 : 1) * (i == 0 || i + 1 == nodes.size() ? 0.5 : 1) / (u - nodes[i]);
        sum += weights[i];
    }
    for (double& w : weights) w /= sum;
    return weights;
}

}  // namespace

ChebyshevPatch::ChebyshevPatch(const Rectangle& box, int count, const std::function<double(const Point<2>&)>& f)
    : box_(box) {
    for (int i = 0; i < count; ++i) nodes_.push_back((1 - std::cos(std::numbers::pi * i / (count - 1))) / 2);
    for (const double u : nodes_)
        for (const double v : nodes_)
            values_.push_back(
                f({box.low[0] + u * (box.high[0] - box.low[0]), box.low[1] + v * (box.high[1] - box.low[1])}));
}

double ChebyshevPatch::operator()(const Point<2>& x) const {
    const auto row = barycentric(nodes_, (x[0] - box_.low[0]) / (box_.high[0] - box_.low[0]));
    const auto column = barycentric(nodes_, (x[1] - box_.low[1]) / (box_.high[1] - box_.low[1]));
    double sum = 0;
    for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t j = 0; j < column.size(); ++j) sum += row[i] * column[j] * values_[i * column.size() + j];
    return sum;
}

}  // namespace plumb
