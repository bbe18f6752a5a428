#pragma once

#include <cstdint>
#include <limits>

namespace plumb {

/// The answer of an estimator: a value never travels without its error. standard_error is infinite where the method
/// cannot know it (one stratified, quasi-random or Voronoi set has no independent replicates); evaluations counts calls
/// of the integrand, end-point evaluations included.
struct Estimate {
    double value = 0;
    double standard_error = std::numeric_limits<double>::infinity();
    std::uint64_t evaluations = 0;
};

}  // namespace plumb
