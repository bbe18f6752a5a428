#pragma once

#include <cstdint>
#include <vector>

#include "core/point.h"
#include "core/random.h"

namespace plumb {

/// Correlated multi-jittered sampling [Kensler 2013]: one point in each of the n cells of grid_of(n), and one in each
/// of n columns and each of n rows. The place within a cell's column is set by the cell's row, through one permutation
/// that all columns share (and vice versa): "correlated", which keeps neighbours apart, but moves whole rows of cells
/// together, so that smooth integrands that are not sums over the axes converge like n^-1.5 where stratified_2d reaches
/// n^-2 (point_set_slopes.cpp).
/// Ours: true random permutations where the paper hashes an index, and cells in order (row by row), not shuffled.
std::vector<Point<2>> correlated_multi_jittered_2d(std::uint64_t n, RandomStream& random);

}  // namespace plumb
