#include "estimators/reweighting/cell_weight_2d.h"

#include <gmock/gmock.h>

#include "analytic/disk_rectangle.h"
#include "core/error.h"

namespace plumb {
namespace {

const std::vector<Point<2>> places{{0, 0}, {0.5, 0.5}, {0.1, 0.4}, {0.001, 0.3}, {1, 0.75}};

/// p = 3/2 on the left half of the square, 1/2 on the right.
const BallMeasure two_piece_ball{[](const Point<2>& centre, double radius) {
                                     return 1.5 * disk_rectangle_area(centre, radius, {{0, 0}, {0.5, 1}}) +
                                            0.5 * disk_rectangle_area(centre, radius, {{0.5, 0}, {1, 1}});
                                 },
                                 {{{0, 0.5, 1}, {0, 1}}}};

/// The definition, by the midpoint rule.
double by_midpoints(std::uint64_t n, const Point<2>& x, const BallMeasure& ball) {
    constexpr int side = 400;
    double sum = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const Point<2> y{(i + 0.5) / side, (j + 0.5) / side};
            sum += std::pow(1 - ball.probability(y, std::hypot(y[0] - x[0], y[1] - x[1])), static_cast<double>(n - 1));
        }
    return static_cast<double>(n) * sum / (side * side);
}

TEST(CellWeight2D, OfOneSampleIs1) {
    for (const Point<2>& x : places) {
        EXPECT_NEAR(cell_weight_2d(1, x, uniform_ball()), 1, 1e-14);
        EXPECT_NEAR(cell_weight_2d(1, x, two_piece_ball), 1, 1e-14);
    }
}

TEST(CellWeight2D, AgreesWithTheMidpointRule) {
    for (const Point<2>& x : places)
        for (const std::uint64_t n : {2, 5, 20}) {
            EXPECT_NEAR(cell_weight_2d(n, x, uniform_ball()), by_midpoints(n, x, uniform_ball()), 5e-5) << n;
            EXPECT_NEAR(cell_weight_2d(n, x, two_piece_ball), by_midpoints(n, x, two_piece_ball), 1e-4) << n;
        }
}

TEST(CellWeight2D, IsRightAwayFromTheBoundary) {
    // ∫ (1 − πr²)^{N−1} 2πr dr over r < 1/√π is 1/N: g = 1 but for the tail that feels the boundary, e^{−π N d²/4}.
    EXPECT_NEAR(cell_weight_2d(400, {0.5, 0.5}, uniform_ball(), 20), 1, 1e-12);
}

TEST(CellWeight2D, OfNoSampleOrOutsideTheSquareIsAnError) {
    EXPECT_THROW((void)cell_weight_2d(0, {0, 0}, uniform_ball()), Error);
    EXPECT_THROW((void)cell_weight_2d(2, {0, 1.5}, uniform_ball()), Error);
    EXPECT_THROW((void)cell_weight_2d(2, {std::nan(""), 0}, uniform_ball()), Error);
    EXPECT_THROW((void)CellWeightTable2D(2, 5)({0.5, std::nan("")}), Error);
}

TEST(CellWeightTable2D, StaysWithinItsError) {
    for (const std::uint64_t n : {4, 64, 1024}) {
        const CellWeightTable2D table(n);
        EXPECT_LT(table.error(), 3e-4) << n;
        for (const Point<2>& x : std::vector<Point<2>>{{0.013, 0.877}, {0.33, 0.31}, {0.98, 0.02}, {0.5, 0.07}})
            EXPECT_NEAR(table(x), cell_weight_2d(n, x, uniform_ball(), 24), table.error()) << n;
    }
}

TEST(CellWeightTable2D, IntegratesTo1BecauseCellsFillTheSquare) {
    const CellWeightTable2D uniform(5), two_piece(5, two_piece_ball);
    constexpr int side = 200;
    double sum = 0, sum_p = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const Point<2> x{(i + 0.5) / side, (j + 0.5) / side};
            sum += uniform(x);
            sum_p += two_piece(x) * (x[0] < 0.5 ? 1.5 : 0.5);
        }
    EXPECT_NEAR(sum / (side * side), 1, uniform.error() + 2e-5);
    EXPECT_NEAR(sum_p / (side * side), 1, two_piece.error() + 5e-5);
}

}  // namespace
}  // namespace plumb
