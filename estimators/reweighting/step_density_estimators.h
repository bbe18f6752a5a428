#pragma once

#include "analytic/step_density.h"
#include "estimators/estimator.h"

namespace plumb {

/// Three ways to integrate with samples of a piecewise-constant density, as estimators named `id`.

/// The mean of f/p over independent samples of p: plain importance sampling.
Estimator<1> step_importance_estimator(std::string id, StepDensity density);

/// Fixed counts a piece, each piece reweighted by itself [thesis, section 4.4.4]; n is at least the number of pieces.
Estimator<1> step_strata_estimator(std::string id, StepDensity density);

/// Independent samples of p, Voronoi cells over g p, with the closed form of g for p.
Estimator<1> step_reweighted_estimator(std::string id, StepDensity density);

}  // namespace plumb
