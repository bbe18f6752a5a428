#include "estimators/points/multi_jittered.h"

#include "estimators/points/point_count.h"
#include "estimators/points/strata.h"

namespace plumb {

std::vector<Point<2>> correlated_multi_jittered_2d(std::uint64_t n, RandomStream& random) {
    const Grid grid = grid_of(point_count(n, "cmj"));
    const auto fine_column = random_permutation(static_cast<std::uint32_t>(grid.rows), random);
    const auto fine_row = random_permutation(static_cast<std::uint32_t>(grid.columns), random);
    std::vector<Point<2>> points;
    points.reserve(n);
    for (std::uint64_t row = 0; row < grid.rows; ++row)
        for (std::uint64_t column = 0; column < grid.columns; ++column) {
            const double x = in_stratum(column * grid.rows + fine_column[row], n, random.uniform());
            const double y = in_stratum(row * grid.columns + fine_row[column], n, random.uniform());
            points.push_back({x, y});
        }
    return points;
}

}  // namespace plumb
