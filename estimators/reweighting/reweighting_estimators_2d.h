#pragma once

#include <vector>

#include "estimators/estimator.h"
#include "estimators/reweighting/cell_weight_2d.h"

namespace plumb {

/// Geometric sample reweighting in the square, as lines of the list of estimators.
std::vector<Estimator<2>> reweighting_estimators_2d();

/// The table of g for n uniform samples, built when first asked for and then kept; threads may ask at once.
const CellWeightTable2D& uniform_cell_weight(std::uint64_t n);

}  // namespace plumb
