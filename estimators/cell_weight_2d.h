#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/point.h"

namespace plumb {

// g(x) = N E[|V| given a sample at x], for the clipped Voronoi cell V of one of N i.i.d. samples with density p on the
// unit square, so that Σ |V_i| f(x_i)/(g(x_i) p(x_i)) is unbiased for every f that vanishes where p does:
//
//     g(x) = N ∫_Ω (1 − P(B(y, |y−x|)))^{N−1} dy,
//
// since y belongs to the cell of x when none of the other N−1 samples is nearer.

/// P(B(centre, radius) ∩ Ω) under the density of one sample; the centre lies in the square.
using BallProbability = std::function<double(const Point<2>& centre, double radius)>;

/// That of uniform samples: the area of the disk in the square.
double uniform_ball(const Point<2>& centre, double radius);

/// g(x) by quadrature of the given order: along rays from x to the boundary, split where the ball along the ray touches
/// a side or reaches a corner, with weights of Gauss and Legendre.
double cell_weight_2d(std::uint64_t n, const Point<2>& x, const BallProbability& ball, int order = 12);

/// g tabulated: interpolated between Chebyshev nodes. For uniform samples the table uses the symmetries of the square
/// and covers only the layer along the boundary, some 7/√N wide, in which g differs from 1 by more than 1e-15.
class CellWeightTable2D {
public:
    CellWeightTable2D(std::uint64_t n, const BallProbability& ball, int nodes = 25);
    /// For uniform samples.
    explicit CellWeightTable2D(std::uint64_t n, int nodes = 25);

    [[nodiscard]] double operator()(Point<2> x) const;
    /// What |table(x) − g(x)| is below: four times the largest difference at 64 places between the nodes from a
    /// quadrature of higher order. Measured, not proved; voronoi_test holds it to independent quadratures.
    [[nodiscard]] double error() const { return error_; }
    /// The smallest and largest tabulated values.
    [[nodiscard]] double smallest() const;
    [[nodiscard]] double largest() const;

private:
    void fill(std::uint64_t n, const BallProbability& ball);
    [[nodiscard]] Point<2> folded(Point<2> x) const;

    bool symmetric_;
    double width_;                ///< the table covers [0, width]²
    std::vector<double> nodes_;   ///< on one axis
    std::vector<double> values_;  ///< row by row
    double error_ = 0;
};

}  // namespace plumb
