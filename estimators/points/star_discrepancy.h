#pragma once

#include <vector>

#include "core/point.h"

namespace plumb {

/// The largest difference between the share of points in a box [0,x) or [0,x] anchored at the origin and its volume,
/// over all boxes: exact up to rounding. Points lie in [0,1]^D and may coincide; throws Error for an empty set and for
/// a point that is outside or NaN, naming its index.
/// 1D: O(n log n) [Niederreiter 1992, theorem 2.6]. 2D: O(n^2) [Bundschuh & Zhu 1993].
double star_discrepancy(const std::vector<Point<1>>& points);
double star_discrepancy(const std::vector<Point<2>>& points);

}  // namespace plumb
