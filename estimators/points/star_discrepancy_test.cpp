#include "estimators/points/star_discrepancy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/random.h"
#include "estimators/points/halton.h"
#include "estimators/points/stratified.h"

namespace plumb {
namespace {

TEST(StarDiscrepancy, OfGrids1D) {
    std::vector<Point<1>> left, centred;
    for (int i = 0; i < 8; ++i) {
        left.push_back({i / 8.0});
        centred.push_back({(i + 0.5) / 8});
    }
    EXPECT_EQ(star_discrepancy(left), 1.0 / 8);
    EXPECT_EQ(star_discrepancy(centred), 1.0 / 16);
}

TEST(StarDiscrepancy, OfOnePoint) {
    // The open boxes (x,1) and (1,y) hold nothing; the closed box to the point itself holds all.
    EXPECT_EQ(star_discrepancy({Point<2>{0.75, 0.5}}), 0.75);
    EXPECT_EQ(star_discrepancy({Point<2>{0.25, 0.5}}), 1 - 0.125);
    EXPECT_EQ(star_discrepancy({Point<2>{0, 0}}), 1);
    EXPECT_EQ(star_discrepancy({Point<2>{1, 1}}), 1);
}

/// The discrepancy by definition, over the corners at which the supremum is attained: all pairs of coordinates, and 1.
double by_all_critical_boxes(const std::vector<Point<2>>& points) {
    std::vector<double> xs{1}, ys{1};
    for (const auto& [x, y] : points) {
        xs.push_back(x);
        ys.push_back(y);
    }
    double worst = 0;
    for (const double x : xs)
        for (const double y : ys) {
            const auto open = std::ranges::count_if(points, [=](auto& p) { return p[0] < x && p[1] < y; });
            const auto closed = std::ranges::count_if(points, [=](auto& p) { return p[0] <= x && p[1] <= y; });
            const double n = static_cast<double>(points.size());
            worst = std::max({worst, x * y - static_cast<double>(open) / n, static_cast<double>(closed) / n - x * y});
        }
    return worst;
}

TEST(StarDiscrepancy, AgreesWithAllCriticalBoxes) {
    RandomStream random(4);
    for (std::uint64_t n = 1; n < 40; ++n) {
        const auto points = independent_points<2>(n, random);
        EXPECT_DOUBLE_EQ(star_discrepancy(points), by_all_critical_boxes(points));
        EXPECT_DOUBLE_EQ(star_discrepancy(halton_2d(n)), by_all_critical_boxes(halton_2d(n)));
    }
}

TEST(StarDiscrepancy, OfPointsOnAnEdge) {
    // The closed box [0,1] x [0,0] holds all points and no volume.
    EXPECT_EQ(star_discrepancy({{0.25, 0}, {0.75, 0}, {0.5, 0}}), 1);
    // On the far edge: no box of height below 1 holds any.
    EXPECT_EQ(star_discrepancy({{0.25, 1}, {0.75, 1}}), 1);
}

TEST(StarDiscrepancy, NamesABadPoint) {
    const auto message = [](const std::vector<Point<2>>& points) {
        try {
            star_discrepancy(points);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_THAT(message({{0.5, 0.5}, {0.5, 1.5}}), testing::HasSubstr("point 1 has the coordinate 1.5"));
    EXPECT_THAT(message({{std::nan(""), 0.5}}), testing::HasSubstr("point 0 has the coordinate nan"));
    EXPECT_THAT(message({}), testing::HasSubstr("no points"));
}

}  // namespace
}  // namespace plumb
