#pragma once

#include <span>
#include <vector>

#include "core/point.h"

namespace plumb {

// The reference that needs no trust: every cell is the square cut by the bisector with every other sample. O(N²).

/// Cells clipped to [0,1]², like voronoi_areas().
std::vector<double> brute_force_voronoi_areas(std::span<const Point<2>> samples);

/// Cells on the unit torus, like voronoi_areas_periodic() but without rounding positions.
std::vector<double> brute_force_voronoi_areas_periodic(std::span<const Point<2>> samples);

}  // namespace plumb
