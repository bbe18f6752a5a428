#pragma once

#include <functional>
#include <span>
#include <vector>

#include "analytic/cell_weight_density.h"
#include "analytic/step_density.h"

namespace plumb {

/// Sample weights whose weighted sum of f estimates ∫_0^1 f without bias [thesis, chapter 4] and methods of ours. All
/// take the samples in any order, return weights in that order, and throw as voronoi_weights_1d does. The torus's cells
/// (cells_1d.h) need no such correction. Unlike plain cells, these weights need not sum to 1.

/// |V_i|/g_N(x_i) for i.i.d. uniform samples [thesis, eq. 4.8]. The boundary cells keep a random factor of order 1,
/// so the MSE falls only like N^-2 where f(0) or f(1) is not 0.
std::vector<double> reweighted_weights_1d(std::span<const double> samples);

/// |V_i|/g_s(x_i) for one jittered sample in each of N equal strata.
std::vector<double> stratified_reweighted_weights_1d(std::span<const double> samples);

/// |V_i|/(g(x_i) p(x_i)) for i.i.d. samples of the density p, with g as given (for p, N and this number of samples).
/// p > 0 wherever f is not 0.
std::vector<double> density_reweighted_weights_1d(std::span<const double> samples,
                                                  const std::function<double(double)>& g,
                                                  const std::function<double(double)>& pdf);

/// The same with the closed form of g for a piecewise-constant p.
std::vector<double> density_reweighted_weights_1d(std::span<const double> samples, const StepDensity& density);

/// The trapezoidal rule on the samples and both ends [Yakowitz et al. 1978]: weights of the samples, then of 0 and
/// of 1.
std::vector<double> trapezoid_weights_1d(std::span<const double> samples);

}  // namespace plumb
