#pragma once

#include <string>
#include <vector>

#include "checks/sampler/cell_density.h"

namespace plumb::cli {

/// The density that is proportional to a formula of x (and y) on a domain x0, x1[, y0, y1], the unit cube where it is
/// empty. Throws Error for what cannot be read, is negative or not finite somewhere, or does not let itself be summed.
checks::CellDensity formula_density(const std::string& text, const std::vector<double>& domain);

}  // namespace plumb::cli
