#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "analytic/step_density.h"

namespace plumb {

/// g(x) = N E[|V| given a sample at x] for N i.i.d. samples of a density p on [0,1], so that Σ |V_i| f(x_i)/(g(x_i)
/// p(x_i)) is unbiased. In general g(x) = N ∫ (1 − P(B(y, |y−x|)))^{N−1} dy: y belongs to x's cell when no other sample
/// is nearer. In one dimension the ball is the interval between x and z = 2y − x, which leaves one integral:
///
///     g(x) = N/2 [ x (1 − F(x))^{N−1} + (1 − x) F(x)^{N−1} + ∫_0^1 (1 − |F(x) − F(z)|)^{N−1} dz ],
///
/// F the distribution function. For F(z) = z this is [thesis, eq. 4.6].

/// A density on [0,1] as g sees it: the pdf with its distribution function.
struct Density1D {
    std::function<double(double)> pdf, cdf;
    double largest = 0;    ///< sup p
    double variation = 0;  ///< total variation of p on [0,1]
    double lipschitz = 0;  ///< sup |p'|
};

/// A number with a bound of its error.
struct BoundedValue {
    double value = 0, error = 0;  ///< the truth lies within value ± error
};

/// g(x) by the trapezoidal rule on `panels` equal panels to each side of x, with a derived bound of its error
/// (rounding, of order 1e-13, aside).
BoundedValue cell_weight_by_quadrature(std::uint64_t n, double x, const Density1D& density, int panels);

/// g(x) in closed form for a piecewise-constant density.
double piecewise_cell_weight(std::uint64_t n, double x, const StepDensity& density);

/// g tabulated by quadrature, linear in between; |table(x) − g(x)| ≤ error_bound() ≤ tolerance everywhere.
/// Throws Error when the tolerance asks for more than 2^26 values of the distribution function: the inverse-CDF warp
/// serves large N.
class CellWeightTable {
public:
    CellWeightTable(std::uint64_t n, const Density1D& density, double tolerance);
    [[nodiscard]] double operator()(double x) const;
    [[nodiscard]] double error_bound() const { return error_bound_; }

private:
    std::vector<double> values_;
    double error_bound_ = 0;
};

}  // namespace plumb
