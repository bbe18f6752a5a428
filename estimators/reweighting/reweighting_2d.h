#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/point.h"
#include "core/random.h"
#include "estimators/estimator.h"

namespace plumb {

// Integrals over the unit square from samples weighted by their Voronoi cells [thesis, chapter 4], the torus ours.
// All take any samples in any order; NaN, infinities, points outside the square and empty sets throw Error. Cells are
// dependent, so one set has no standard error: that comes from independent sets (replicates.h).

/// Σ w_i f(x_i).
Estimate weighted_sum(const Function<2>& f, std::span<const Point<2>> samples, std::span<const double> weights);

/// Weights |V_i|, cells clipped to the square. The expectation for i.i.d. uniform samples is ∫ g f (cell_weight_2d.h).
Estimate voronoi_estimate(const Function<2>& f, std::span<const Point<2>> samples);

/// Weights |V_i|, cells on the torus. Moving all samples by one vector moves all cells: so E[|V_i| given x_i] does not
/// depend on x_i, for i.i.d. uniform samples and for any set with one uniform random shift; it is 1/N on average,
/// because the weights sum to 1. Unbiased.
Estimate torus_estimate(const Function<2>& f, std::span<const Point<2>> samples);

/// The same for f∘φ, φ the tent map on each axis: continuous on the torus where f is continuous. Unbiased.
Estimate torus_tent_estimate(const Function<2>& f, std::span<const Point<2>> samples);

/// Torus weights on any samples moved by one uniform vector on the torus. Unbiased.
Estimate shifted_torus_estimate(const Function<2>& f, std::vector<Point<2>> samples, RandomStream& random);

/// Weights |V_i|/(g(x_i) p(x_i)), clipped cells, for i.i.d. samples of the density p and the g of p and this number of
/// samples (cell_weight_2d.h). Unbiased when p > 0 wherever f is not 0. Throws Error where g p is not positive.
std::vector<double> reweighted_weights_2d(std::span<const Point<2>> samples, const Function<2>& g,
                                          const Function<2>& pdf);

}  // namespace plumb
