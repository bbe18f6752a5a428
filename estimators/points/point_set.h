#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analytic/integrand.h"
#include "core/interval.h"
#include "core/point.h"
#include "core/random.h"

namespace plumb {

/// A way to place n points in [0,1)^D, under a name. The code of each stands in a file of its own as a free function.
template <int D>
struct PointSet {
    std::string id, summary, source;
    /// A point picked at random from the set is exactly uniform (to 53 digits), so that the mean over the set is
    /// unbiased for every n. Otherwise the set is always the same.
    bool randomised = true;
    bool independent = false;  ///< of each other: then the spread of the values gives the standard error
    /// Exactly n points, for every n < 2^32; a set that is not randomised leaves the stream alone.
    std::function<std::vector<Point<D>>(std::uint64_t n, RandomStream&)> generate;
    /// The exponents of the MSE of the mean over the set (point_set_slopes.h).
    std::function<std::optional<Interval>(const Integrand<D>&)> expected_slope;
};

const std::vector<PointSet<1>>& point_sets_1d();
const std::vector<PointSet<2>>& point_sets_2d();

}  // namespace plumb
