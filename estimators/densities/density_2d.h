#pragma once

#include <fmt/format.h>

#include "core/point.h"
#include "estimators/densities/density.h"

namespace plumb {

// Densities on the unit square, with the same three functions as in density.h, on points.

/// The product density p(x, y) = p_x(x) p_y(y).
template <class X, class Y>
struct ProductDensity {
    X x;
    Y y;

    [[nodiscard]] Point<2> sample(const Point<2>& u) const { return {x.sample(u[0]), y.sample(u[1])}; }
    [[nodiscard]] double pdf(const Point<2>& p) const { return x.pdf(p[0]) * y.pdf(p[1]); }
    [[nodiscard]] Point<2> invert(const Point<2>& p) const { return {x.invert(p[0]), y.invert(p[1])}; }
};

/// The density proportional to the bilinear interpolation of four values ≥ 0 at the corners: the marginal of x is
/// linear between the sums of the two sides, and y given x is linear between the interpolated ends.
class BilinearDensity {
public:
    /// at_10 is the value at x = 1, y = 0.
    BilinearDensity(double at_00, double at_10, double at_01, double at_11)
        : at_00_(at_00), at_10_(at_10), at_01_(at_01), at_11_(at_11), marginal_(at_00 + at_01, at_10 + at_11) {
        if (!(at_00 >= 0 && at_10 >= 0 && at_01 >= 0 && at_11 >= 0))
            throw Error(fmt::format("bilinear density with corners {}, {}, {}, {}: all must be >= 0", at_00, at_10,
                                    at_01, at_11));
    }

    [[nodiscard]] Point<2> sample(const Point<2>& u) const {
        const double x = marginal_.sample(u[0]);
        return {x, given(x).sample(u[1])};
    }
    [[nodiscard]] double pdf(const Point<2>& p) const {
        const double marginal = marginal_.pdf(p[0]);
        return marginal > 0 ? marginal * given(p[0]).pdf(p[1]) : 0;
    }
    [[nodiscard]] Point<2> invert(const Point<2>& p) const {
        return {marginal_.invert(p[0]), marginal_.pdf(p[0]) > 0 ? given(p[0]).invert(p[1]) : 0};
    }

private:
    [[nodiscard]] LinearDensity given(double x) const {
        return {(1 - x) * at_00_ + x * at_10_, (1 - x) * at_01_ + x * at_11_};
    }

    double at_00_, at_10_, at_01_, at_11_;
    LinearDensity marginal_;
};

}  // namespace plumb
