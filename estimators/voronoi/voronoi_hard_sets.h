#pragma once

#include <string>
#include <vector>

#include "core/point.h"

namespace plumb {

/// Samples at which Voronoi cells degenerate.
struct HardSet {
    std::string name;
    std::vector<Point<2>> samples;
    bool separated = true;  ///< distinct samples differ by more than the rounding to multiples of 2^-52 on the torus
};

/// One and two samples, coincident, on the boundary and the corners, collinear, on one circle (also with its centre),
/// on a grid, clustered within 1e-12, at 2^-1074 and 1 − 2^-53.
std::vector<HardSet> voronoi_hard_sets();

}  // namespace plumb
