#include "verification/suites/points/defective_point_sets.h"

#include <algorithm>
#include <cmath>

#include "estimators/points/halton.h"
#include "estimators/points/random_shift.h"
#include "estimators/points/sobol.h"
#include "estimators/points/strata.h"

namespace plumb::suites {

template <int D>
Generate<D> left_part_of_strata(Generate<D> generate, std::function<std::uint64_t(std::uint64_t n)> strata, double c) {
    return [=](std::uint64_t n, RandomStream& random) {
        auto points = generate(n, random);
        for (Point<D>& point : points) {
            const double edge = stratum_edge(stratum_of(point[0], strata(n)), strata(n));
            point[0] = edge + c * (point[0] - edge);
        }
        return points;
    };
}
template Generate<1> left_part_of_strata<1>(Generate<1>, std::function<std::uint64_t(std::uint64_t)>, double);
template Generate<2> left_part_of_strata<2>(Generate<2>, std::function<std::uint64_t(std::uint64_t)>, double);

template <int D>
Generate<D> few_digits(Generate<D> generate, int digits) {
    return [=](std::uint64_t n, RandomStream& random) {
        auto points = generate(n, random);
        for (Point<D>& point : points)
            for (double& x : point) x = std::ldexp(std::floor(std::ldexp(x, digits)), -digits);
        return points;
    };
}
template Generate<1> few_digits<1>(Generate<1>, int);
template Generate<2> few_digits<2>(Generate<2>, int);

namespace {

template <int D, class Shift, class Wrap>
Generate<D> moved(std::vector<Point<D>> (*points)(std::uint64_t), Shift shift, Wrap wrap) {
    return [=](std::uint64_t n, RandomStream& random) {
        auto set = points(n);
        const Point<D> by = shift(random);
        for (Point<D>& point : set)
            for (int axis = 0; axis < D; ++axis) point[axis] = wrap(point[axis] + by[axis]);
        return set;
    };
}

template <int D>
auto shift_within(double c) {
    return [c](RandomStream& random) {
        Point<D> shift;
        for (double& s : shift) s = c * random.uniform();
        return shift;
    };
}

double wrapped(double x) {
    return x < 1 ? x : x - 1;
}

}  // namespace

template <int D>
Generate<D> short_shift(std::vector<Point<D>> (*points)(std::uint64_t), double c) {
    return moved<D>(points, shift_within<D>(c), wrapped);
}
template Generate<1> short_shift<1>(std::vector<Point<1>> (*)(std::uint64_t), double);
template Generate<2> short_shift<2>(std::vector<Point<2>> (*)(std::uint64_t), double);

template <int D>
Generate<D> shift_without_wrap(std::vector<Point<D>> (*points)(std::uint64_t)) {
    return moved<D>(points, shift_within<D>(1), [](double x) { return x; });
}
template Generate<1> shift_without_wrap<1>(std::vector<Point<1>> (*)(std::uint64_t));
template Generate<2> shift_without_wrap<2>(std::vector<Point<2>> (*)(std::uint64_t));

Generate<2> shift_shared_by_axes(std::vector<Point<2>> (*points)(std::uint64_t)) {
    const auto shared = [](RandomStream& random) {
        const double s = random.uniform();
        return Point<2>{s, s};
    };
    return moved<2>(points, shared, wrapped);
}

namespace {

/// Columns in order, the row of column i given.
std::vector<Point<2>> jittered(const std::vector<std::uint32_t>& column, const std::vector<std::uint32_t>& row,
                               RandomStream& random) {
    std::vector<Point<2>> points(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double x = in_stratum(column[i], row.size(), random.uniform());
        points[i] = {x, in_stratum(row[i], row.size(), random.uniform())};
    }
    return points;
}

std::vector<std::uint32_t> in_order(std::uint64_t n) {
    std::vector<std::uint32_t> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<std::uint32_t>(i);
    return order;
}

}  // namespace

std::vector<Point<2>> latin_hypercube_by_naive_shuffle(std::uint64_t n, RandomStream& random) {
    auto row = in_order(n);
    for (std::uint32_t& r : row) std::swap(r, row[random.below(n)]);
    return jittered(in_order(n), row, random);
}

std::vector<Point<2>> latin_hypercube_with_one_permutation(std::uint64_t n, RandomStream& random) {
    const auto order = random_permutation(static_cast<std::uint32_t>(n), random);
    return jittered(order, order, random);
}

std::vector<Point<2>> latin_hypercube_with_repeated_rows(std::uint64_t n, RandomStream& random) {
    auto row = in_order(n);
    for (std::uint32_t& r : row) r = static_cast<std::uint32_t>(random.below(n));
    return jittered(in_order(n), row, random);
}

namespace {

/// One point in each cell of the grid: the fine column within the cell's column, and the fine row, as given.
template <class FineColumn, class FineRow>
std::vector<Point<2>> multi_jittered(const Grid& grid, FineColumn fine_column, FineRow fine_row, RandomStream& random) {
    std::vector<std::uint32_t> column, row;
    for (std::uint64_t r = 0; r < grid.rows; ++r)
        for (std::uint64_t c = 0; c < grid.columns; ++c) {
            column.push_back(static_cast<std::uint32_t>(c * grid.rows + fine_column(c, r)));
            row.push_back(static_cast<std::uint32_t>(r * grid.columns + fine_row(c, r)));
        }
    return jittered(column, row, random);
}

std::vector<std::vector<std::uint32_t>> permutations(std::uint64_t count, std::uint64_t size, RandomStream& random) {
    std::vector<std::vector<std::uint32_t>> all(count);
    for (auto& one : all) one = random_permutation(static_cast<std::uint32_t>(size), random);
    return all;
}

}  // namespace

std::vector<Point<2>> multi_jittered_by_own_index(std::uint64_t n, RandomStream& random) {
    const Grid grid = grid_of(n);
    const auto fine_column = random_permutation(static_cast<std::uint32_t>(grid.columns), random);
    const auto fine_row = random_permutation(static_cast<std::uint32_t>(grid.rows), random);
    return multi_jittered(
        grid, [&](auto c, auto) { return fine_column[c] % grid.rows; },
        [&](auto, auto r) { return fine_row[r] % grid.columns; }, random);
}

std::vector<Point<2>> multi_jittered_uncorrelated(std::uint64_t n, RandomStream& random) {
    const Grid grid = grid_of(n);
    const auto fine_column = permutations(grid.columns, grid.rows, random);
    const auto fine_row = permutations(grid.rows, grid.columns, random);
    return multi_jittered(
        grid, [&](auto c, auto r) { return fine_column[c][r]; }, [&](auto c, auto r) { return fine_row[r][c]; },
        random);
}

std::vector<Point<2>> multi_jittered_half_correlated(std::uint64_t n, RandomStream& random) {
    const Grid grid = grid_of(n);
    const auto fine_column = random_permutation(static_cast<std::uint32_t>(grid.rows), random);
    const auto fine_row = permutations(grid.rows, grid.columns, random);
    return multi_jittered(
        grid, [&](auto, auto r) { return fine_column[r]; }, [&](auto c, auto r) { return fine_row[r][c]; }, random);
}

std::vector<Point<2>> multi_jittered_unshuffled(std::uint64_t n, RandomStream& random) {
    return multi_jittered(
        grid_of(n), [](auto, auto r) { return r; }, [](auto c, auto) { return c; }, random);
}

std::vector<Point<1>> xor_van_der_corput(std::uint64_t n, RandomStream& random) {
    return to_points<1>(digit_shifted<1>(sobol_digits<1>(n), random));
}

std::vector<Point<2>> sobol_without_origin(std::uint64_t n) {
    auto points = sobol_2d(n + 1);
    points.erase(points.begin());
    return points;
}

std::vector<Point<2>> hammersley_from_one(std::uint64_t n) {
    auto points = hammersley_2d(n);
    for (Point<2>& point : points) point[0] += stratum_edge(1, n);
    return points;
}

}  // namespace plumb::suites
