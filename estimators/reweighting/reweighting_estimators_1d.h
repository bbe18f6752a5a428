#pragma once

#include <vector>

#include "estimators/estimator.h"

namespace plumb {

/// Geometric sample reweighting, its relatives and its baselines, as lines of the list of estimators.
std::vector<Estimator<1>> reweighting_estimators_1d();

}  // namespace plumb
