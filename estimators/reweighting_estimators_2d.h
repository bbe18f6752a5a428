#pragma once

#include <vector>

#include "estimators/estimator.h"

namespace plumb {

/// Geometric sample reweighting in the square, as lines of the list of estimators.
std::vector<Estimator<2>> reweighting_estimators_2d();

}  // namespace plumb
