#pragma once

#include <vector>

#include "estimators/estimator.h"
#include "estimators/points/point_set.h"

namespace plumb {

/// The mean over a point set as an estimator under the set's name; unbiased when the set is randomised.
template <int D>
Estimator<D> mean_estimator(const PointSet<D>& set);

/// The estimators of all sets: one for each of point_sets_1d() and point_sets_2d().
std::vector<Estimator<1>> point_set_estimators_1d();
std::vector<Estimator<2>> point_set_estimators_2d();

}  // namespace plumb
