#include "analytic/cell_weight_density.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

void require_sample(std::uint64_t n, double x) {
    if (n == 0) throw Error("a cell weight for 0 samples; at least 1 is needed");
    if (!(x >= 0 && x <= 1)) throw Error(fmt::format("a cell weight at x = {}; x must lie in [0, 1]", x));
}

// N/2 [x (1−F)^{N−1} + (1−x) F^{N−1}]: the parts of the cell beyond which the ball reaches over an end.
double ends(double n, double x, double cdf) {
    return n / 2 * (x * std::pow(1 - cdf, n - 1) + (1 - x) * std::pow(cdf, n - 1));
}

// ∫ (1 − |F(x) − F(z)|)^{N−1} dz from x to `end`, in absolute value, by the trapezoidal rule.
double one_side(double n, double x, double cdf_x, double end, const Density1D& density, int panels) {
    const double h = (end - x) / panels;
    double sum = 0.5 + 0.5 * std::pow(1 - std::abs(cdf_x - density.cdf(end)), n - 1);
    for (int i = 1; i < panels; ++i) sum += std::pow(1 - std::abs(cdf_x - density.cdf(x + i * h)), n - 1);
    return sum * std::abs(h);
}

// A panel of the trapezoidal rule errs by ∫ (z − c) φ'(z) dz, c its middle; φ' may be diminished by a constant there,
// so by at most h²/8 times the oscillation of φ', and all panels together by h²/8 times the total variation of φ'. On
// each side φ = q^{N−1} with q monotone in [0,1] and φ' = ±(N−1) p q^{N−2}: its variation is at most (N−1)(sup p + var
// p) of that side. The two sides' h are at most 1/panels.
double quadrature_bound(double n, const Density1D& density, int panels) {
    const double h = 1.0 / panels;
    return n / 2 * h * h / 8 * (n - 1) * (2 * density.largest + density.variation);
}

// |g''| from the terms of its definition, each factor at most 1 (M = sup p, L = sup |p'|, m = N − 1): the two end terms
// give 2 (m M) + m (m−1) M² + m L each, the two integrals m L + m M + m (m−1) M² each.
double curvature_bound(double n, const Density1D& density) {
    const double m = n - 1, p = density.largest;
    return n / 2 * (4 * m * (m - 1) * p * p + 6 * m * p + 4 * m * density.lipschitz);
}

}  // namespace

BoundedValue cell_weight_by_quadrature(std::uint64_t n, double x, const Density1D& density, int panels) {
    require_sample(n, x);
    if (panels < 1) throw Error(fmt::format("{} panels; at least 1 is needed", panels));
    const double count = static_cast<double>(n), cdf = density.cdf(x);
    const double integral = one_side(count, x, cdf, 0, density, panels) + one_side(count, x, cdf, 1, density, panels);
    return {ends(count, x, cdf) + count / 2 * integral, quadrature_bound(count, density, panels)};
}

double piecewise_cell_weight(std::uint64_t n, double x, const StepDensity& density) {
    require_sample(n, x);
    const double count = static_cast<double>(n), cdf = density.invert(x);
    const auto nearer = [&](double z) { return 1 - std::abs(cdf - density.invert(z)); };
    double integral = 0;  // times N: on a piece of density p, ∫ q^{N−1} dz = |q_1^N − q_0^N|/(N p)
    for (std::size_t k = 0; k < density.pieces(); ++k) {
        const double from = density.edges()[k], to = density.edges()[k + 1];
        const double p = density.masses()[k] / (to - from);
        const double at_from = std::pow(nearer(from), count), at_to = std::pow(nearer(to), count);
        integral += (x <= from ? at_from - at_to : x >= to ? at_to - at_from : 2 - at_from - at_to) / p;
    }
    return ends(count, x, cdf) + integral / 2;
}

CellWeightTable::CellWeightTable(std::uint64_t n, const Density1D& density, double tolerance) {
    if (!(tolerance > 0)) throw Error(fmt::format("a table of tolerance {}; it must be positive", tolerance));
    const double count = static_cast<double>(n);
    // Half of the tolerance each for the quadrature and for the linear interpolation, which errs by Δ²/8 sup |g''|.
    const double panels = std::ceil(std::sqrt(2 * quadrature_bound(count, density, 1) / tolerance));
    const double cells = std::ceil(std::sqrt(2 * curvature_bound(count, density) / (8 * tolerance)));
    if (!((panels + 1) * (cells + 1) < 0x1p26))
        throw Error(
            fmt::format("a cell weight table for {} samples within {} needs {:.3g} values; at most 2^26 are accepted",
                        n, tolerance, panels * cells));
    const int last = std::max(1, static_cast<int>(cells));
    for (int i = 0; i <= last; ++i) {
        const BoundedValue g =
            cell_weight_by_quadrature(n, static_cast<double>(i) / last, density, std::max(1, static_cast<int>(panels)));
        values_.push_back(g.value);
        error_bound_ = g.error;
    }
    error_bound_ += curvature_bound(count, density) / (8.0 * last * last);
}

double CellWeightTable::operator()(double x) const {
    if (!(x >= 0 && x <= 1)) throw Error(fmt::format("a cell weight at x = {}; x must lie in [0, 1]", x));
    const double last = static_cast<double>(values_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(x * last), values_.size() - 2);
    const double t = x * last - static_cast<double>(i);
    return (1 - t) * values_[i] + t * values_[i + 1];
}

}  // namespace plumb
