#pragma once

#include <vector>

#include "checks/bsdf/cases.h"

namespace plumb::checks {

/// What a density often has too much: cosines, and the Jacobian of the half vector [Walter et al. 2007, eq. 14].
std::vector<Factor> factors_of_densities();
/// What eval() often lacks or has twice: cosines.
std::vector<Factor> factors_of_values();
/// By which f(wo, wi)/f(wi, wo) differs from 1 where eval() lacks the factor.
std::vector<Factor> factors_of_reciprocity();

}  // namespace plumb::checks
