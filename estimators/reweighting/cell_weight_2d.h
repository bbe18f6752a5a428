#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/point.h"
#include "estimators/reweighting/chebyshev_patch.h"

namespace plumb {

// g(x) = N E[|V| given a sample at x], for the clipped Voronoi cell V of one of N i.i.d. samples with density p on the
// unit square, so that Σ |V_i| f(x_i)/(g(x_i) p(x_i)) is unbiased for every f that vanishes where p does:
//
//     g(x) = N ∫_Ω (1 − P(B(y, |y−x|)))^{N−1} dy,
//
// since y belongs to the cell of x when none of the other N−1 samples is nearer.

/// A density on the unit square as g sees it.
struct BallMeasure {
    /// P(B(centre, radius) ∩ Ω); the centre lies in the square.
    std::function<double(const Point<2>& centre, double radius)> probability;
    /// The lines x = c and y = c on which the density jumps, from 0 to 1 in order: quadratures and tables split there.
    std::array<std::vector<double>, 2> jumps{{{0, 1}, {0, 1}}};
};

/// The measure of uniform samples: the area of the disk in the square.
BallMeasure uniform_ball();

/// g(x) by quadrature of the given order: along rays from x to the boundary, split where the ball along the ray touches
/// a line of jumps or reaches a crossing of two, by Gauss and Legendre's rule. Throws Error for n = 0 and for x
/// outside.
double cell_weight_2d(std::uint64_t n, const Point<2>& x, const BallMeasure& ball, int order = 12);

/// g tabulated, by Chebyshev interpolation between the lines on which the density jumps. For uniform samples the table
/// uses the symmetries of the square and covers only the layer along the boundary, 7/√N wide, beyond which g differs
/// from 1 by less than 1e-15.
class CellWeightTable2D {
public:
    CellWeightTable2D(std::uint64_t n, const BallMeasure& ball, int nodes = 13);
    /// The table for uniform samples.
    explicit CellWeightTable2D(std::uint64_t n, int nodes = 25);

    [[nodiscard]] double operator()(Point<2> x) const;
    /// A bound of |table(x) − g(x)|: four times the largest difference from a quadrature of higher order at 64
    /// random places. Measured, not proved; voronoi_test holds table and quadrature to the midpoint rule.
    [[nodiscard]] double error() const { return error_; }
    /// The smallest and largest tabulated values.
    [[nodiscard]] double smallest() const;
    [[nodiscard]] double largest() const;

private:
    void measure_error(std::uint64_t n, const BallMeasure& ball);

    std::vector<ChebyshevPatch> patches_;
    double fold_ = 1;  ///< coordinates are mirrored at 1/2 and cut off here, if below 1
    double error_ = 0;
};

}  // namespace plumb
