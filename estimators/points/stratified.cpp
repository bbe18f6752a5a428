#include "estimators/points/stratified.h"

#include "estimators/points/strata.h"

namespace plumb {

template <int D>
std::vector<Point<D>> independent_points(std::uint64_t n, RandomStream& random) {
    std::vector<Point<D>> points(n);
    for (Point<D>& point : points)
        for (double& x : point) x = random.uniform();
    return points;
}
template std::vector<Point<1>> independent_points<1>(std::uint64_t, RandomStream&);
template std::vector<Point<2>> independent_points<2>(std::uint64_t, RandomStream&);

std::vector<Point<1>> stratified_1d(std::uint64_t n, RandomStream& random) {
    std::vector<Point<1>> points(n);
    for (std::uint64_t i = 0; i < n; ++i) points[i] = {in_stratum(i, n, random.uniform())};
    return points;
}

std::vector<Point<2>> stratified_2d(std::uint64_t n, RandomStream& random) {
    const Grid grid = grid_of(n);
    std::vector<Point<2>> points;
    points.reserve(n);
    for (std::uint64_t row = 0; row < grid.rows; ++row)
        for (std::uint64_t column = 0; column < grid.columns; ++column) {
            const double x = in_stratum(column, grid.columns, random.uniform());
            points.push_back({x, in_stratum(row, grid.rows, random.uniform())});
        }
    return points;
}

}  // namespace plumb
