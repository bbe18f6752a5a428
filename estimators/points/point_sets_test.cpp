#include <gtest/gtest.h>

#include <set>

#include "estimators/points/latin_hypercube.h"
#include "estimators/points/multi_jittered.h"
#include "estimators/points/point_set.h"
#include "estimators/points/point_set_estimators.h"
#include "estimators/points/random_shift.h"
#include "estimators/points/strata.h"
#include "estimators/points/stratified.h"

namespace plumb {
namespace {

template <int D>
void expect_points_in_the_cube(const std::vector<PointSet<D>>& sets) {
    for (const PointSet<D>& set : sets)
        for (const std::uint64_t n : {1, 2, 3, 7, 12, 16, 61, 100}) {
            RandomStream random(6, n), same(6, n), other(7, n);
            const auto points = set.generate(n, random);
            EXPECT_EQ(points.size(), n) << set.id;
            for (const Point<D>& point : points)
                for (const double x : point) EXPECT_TRUE(0 <= x && x < 1) << set.id << ' ' << x;
            EXPECT_EQ(points, set.generate(n, same)) << set.id;
            EXPECT_EQ(set.randomised, points != set.generate(n, other)) << set.id;
        }
}

TEST(PointSets, AnyCountExactlyInTheCubeAndReproducible) {
    expect_points_in_the_cube(point_sets_1d());
    expect_points_in_the_cube(point_sets_2d());
}

/// The number of n equal intervals that hold a coordinate of this axis.
template <int D>
std::size_t occupied(const std::vector<Point<D>>& points, int axis, std::uint64_t n) {
    std::set<std::uint64_t> strata;
    for (const Point<D>& point : points) strata.insert(stratum_of(point[axis], n));
    return strata.size();
}

std::size_t occupied_cells(const std::vector<Point<2>>& points) {
    const Grid grid = grid_of(points.size());
    std::set<std::pair<std::uint64_t, std::uint64_t>> cells;
    for (const auto& [x, y] : points) cells.emplace(stratum_of(x, grid.columns), stratum_of(y, grid.rows));
    return cells.size();
}

TEST(PointSets, OneSampleInEachStratum) {
    RandomStream random(8);
    for (std::uint64_t n = 1; n <= 60; ++n) {
        EXPECT_EQ(occupied<1>(stratified_1d(n, random), 0, n), n);
        EXPECT_EQ(occupied_cells(stratified_2d(n, random)), n);
        const auto latin = latin_hypercube_2d(n, random), jittered = correlated_multi_jittered_2d(n, random);
        EXPECT_EQ(occupied_cells(jittered), n);
        for (const int axis : {0, 1}) {
            EXPECT_EQ(occupied<2>(latin, axis, n), n);
            EXPECT_EQ(occupied<2>(jittered, axis, n), n);
        }
    }
}

TEST(RandomShift, WrapsAround) {
    RandomStream random(9), same(9);
    const Point<2> shift{same.uniform(), same.uniform()};
    const auto moved = random_shift<2>({{0, 0}, {0.75, 1 - 0x1p-53}}, random);
    EXPECT_EQ(moved[0], shift);
    for (const int axis : {0, 1}) EXPECT_LT(moved[1][axis], 1);
    EXPECT_NEAR(std::fmod(moved[1][0] - shift[0] + 1, 1.0), 0.75, 1e-15);
}

TEST(PointSetEstimators, CarryTheirSets) {
    RandomStream random(10);
    for (const Estimator<2>& estimator : point_set_estimators_2d()) {
        const Estimate one = estimator.run([](const Point<2>&) { return 3.0; }, 10, random);
        EXPECT_DOUBLE_EQ(one.value, 3) << estimator.id;
        EXPECT_EQ(one.evaluations, 10u) << estimator.id;
        EXPECT_EQ(std::isinf(one.standard_error), estimator.id != "independent") << estimator.id;
    }
    EXPECT_EQ(find_estimator<1>("sobol-owen").summary, point_sets_1d().back().summary);
}

TEST(PointSetEstimators, SlopesFollowSmoothness) {
    const auto slope = [](const char* id, Smoothness smoothness) {
        Integrand<2> f;
        f.variance = "1";
        f.smoothness = smoothness;
        return find_estimator<2>(id).expected_slope(f);
    };
    EXPECT_EQ(slope("independent", Smoothness::jump), (Interval{-1, -1}));
    EXPECT_EQ(slope("stratified", Smoothness::kink), (Interval{-2, -2}));
    EXPECT_EQ(slope("stratified", Smoothness::jump), (Interval{-1.5, -1.5}));
    EXPECT_EQ(slope("sobol-owen", Smoothness::analytic), (Interval{-3, -2.64}));
    EXPECT_EQ(slope("sobol-owen", Smoothness::singular), std::nullopt);
    EXPECT_EQ(slope("halton", Smoothness::jump), std::nullopt);
}

}  // namespace
}  // namespace plumb
