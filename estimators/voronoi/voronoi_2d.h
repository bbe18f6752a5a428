#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/point.h"

namespace plumb {

// Areas of the Voronoi cells of samples in the unit square: the part of the domain that lies nearer to a sample than to
// any other. They are non-negative and sum to 1 within 1e-12. Coincident samples share their cell equally. A sample
// that is not a number or outside [0,1]² throws Error naming its index; so does an empty set.
// CGAL's triangulations are GPL-3+: this is the target plumb::voronoi, and only its .cpp includes them.

/// Cells clipped to [0,1]². O(N log N).
std::vector<double> voronoi_areas(std::span<const Point<2>> samples);

/// Cells on the unit torus, where 0 ≡ 1. Positions are rounded to multiples of 2^-52 first, so that every periodic copy
/// of a sample is a double: samples nearer than that coincide.
std::vector<double> voronoi_areas_periodic(std::span<const Point<2>> samples);

/// The same by a dimension known at compile time; cells in three and more dimensions are not built and throw Error.
template <int D>
std::vector<double> voronoi_volumes(std::span<const Point<D>> samples) {
    if constexpr (D == 2) return voronoi_areas(samples);
    throw Error("Voronoi cells in " + std::to_string(D) + " dimensions are not available; accepted are 1 and 2");
}

}  // namespace plumb
