#include "estimators/reweighting/reweighting_1d.h"

#include "analytic/cell_weight.h"
#include "estimators/reweighting/cells_1d.h"

namespace plumb {
namespace {

template <class Divisor>
std::vector<double> cells_over(std::span<const double> samples, Divisor divisor) {
    std::vector<double> weights = voronoi_weights_1d(samples);
    for (std::size_t i = 0; i < samples.size(); ++i) weights[i] /= divisor(samples[i]);
    return weights;
}

}  // namespace

std::vector<double> reweighted_weights_1d(std::span<const double> samples) {
    return cells_over(samples, [n = samples.size()](double x) { return cell_weight(n, x); });
}

std::vector<double> stratified_reweighted_weights_1d(std::span<const double> samples) {
    return cells_over(samples, [n = samples.size()](double x) { return stratified_cell_weight(n, x); });
}

std::vector<double> density_reweighted_weights_1d(std::span<const double> samples,
                                                  const std::function<double(double)>& g,
                                                  const std::function<double(double)>& pdf) {
    return cells_over(samples, [&](double x) { return g(x) * pdf(x); });
}

std::vector<double> density_reweighted_weights_1d(std::span<const double> samples, const StepDensity& density) {
    return cells_over(samples,
                      [&](double x) { return piecewise_cell_weight(samples.size(), x, density) * density.pdf(x); });
}

std::vector<double> trapezoid_weights_1d(std::span<const double> samples) {
    // With the ends among the nodes, a node's half panels are its Voronoi cell.
    std::vector<double> nodes(samples.begin(), samples.end());
    nodes.insert(nodes.end(), {0, 1});
    return voronoi_weights_1d(nodes);
}

}  // namespace plumb
