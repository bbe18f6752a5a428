#pragma once

#include <vector>

#include "estimators/estimator.h"

namespace plumb {

/// Importance sampling, multiple importance sampling, control variate and roulette as estimators of ∫f on the unit
/// cube, with densities that fit any f: uniform, linear (towards 1) and exponential (peaked at 0), all positive
/// everywhere.
std::vector<Estimator<1>> importance_estimators_1d();
std::vector<Estimator<2>> importance_estimators_2d();

}  // namespace plumb
