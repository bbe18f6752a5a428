#include "analytic/disk_rectangle.h"

#include <gtest/gtest.h>

#include <numbers>

#include "analytic/disk_rectangle_exact.h"
#include "analytic/disk_rectangle_hard_cases.h"

namespace plumb {
namespace {

constexpr double pi = std::numbers::pi;

TEST(DiskRectangleArea, OfWholeDisksAndSquares) {
    EXPECT_DOUBLE_EQ(disk_rectangle_area({0.5, 0.5}, 0.25), pi / 16);
    EXPECT_DOUBLE_EQ(disk_rectangle_area({0, 0.5}, 0.25), pi / 32);
    EXPECT_DOUBLE_EQ(disk_rectangle_area({1, 1}, 0.25), pi / 64);
    EXPECT_DOUBLE_EQ(disk_rectangle_area({0.3, 0.4}, 2), 1);
    EXPECT_EQ(disk_rectangle_area({0.3, 0.4}, 0), 0);
}

TEST(DiskRectangleArea, OfADiskThroughTheCornersOfItsSquare) {
    // the unit disk in [0,1] × [0,½]: a triangle of area √3/8, one of area ... by hand: ½(½·√3/2) + π/12
    EXPECT_DOUBLE_EQ(disk_rectangle_area({0, 0}, 1, {{0, 0}, {1, 0.5}}), std::sqrt(3) / 8 + pi / 12);
}

TEST(DiskRectangleArea, WithTheCentreOutside) {
    // a half disk's cap: the unit disk beyond x = ½ has area π/3 − √3/4
    EXPECT_NEAR(disk_rectangle_area({0, 0}, 1, {{0.5, -2}, {2, 2}}), pi / 3 - std::sqrt(3) / 4, 1e-15);
    EXPECT_EQ(disk_rectangle_area({-1, 0.5}, 0.5), 0);
}

TEST(DiskRectangleArea, AddsUpOverThePiecesOfASquare) {
    for (const double radius : {0.1, 0.3, 0.6, 0.9, 1.2}) {
        double sum = 0;
        for (const Point<2>& low : {Point<2>{0, 0}, {0.4, 0}, {0, 0.3}, {0.4, 0.3}})
            sum += disk_rectangle_area({0.7, 0.2}, radius, {low, {low[0] == 0 ? 0.4 : 1, low[1] == 0 ? 0.3 : 1}});
        EXPECT_NEAR(sum, disk_rectangle_area({0.7, 0.2}, radius), 1e-15);
    }
}

TEST(DiskRectangleArea, KeepsItsDigitsInHardCases) {
    for (const DiskCase& c : disk_rectangle_hard_cases()) {
        const double truth = disk_rectangle_area_by_chords(c.centre, c.radius, c.rectangle);
        EXPECT_NEAR(disk_rectangle_area(c.centre, c.radius, c.rectangle) / truth, 1, 8 * 0x1p-53) << c.name;
    }
}

}  // namespace
}  // namespace plumb
