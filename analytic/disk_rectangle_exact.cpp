#include "analytic/disk_rectangle_exact.h"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>

namespace plumb {

using Real = boost::multiprecision::mpfr_float_50;

double disk_rectangle_area_by_chords(const Point<2>& centre, double radius, const Rectangle& rectangle) {
    const Real r = radius;
    const Real x0 = Real(rectangle.low[0]) - centre[0], x1 = Real(rectangle.high[0]) - centre[0];
    const Real y0 = Real(rectangle.low[1]) - centre[1], y1 = Real(rectangle.high[1]) - centre[1];
    const Real from = (std::max)(x0, Real(-r)), to = (std::min)(x1, r);
    if (from >= to) return 0;
    const auto length = [&](const Real& x) -> Real {  // of the vertical chord at x inside the rectangle
        const Real half = sqrt((std::max)(Real(0), Real((r - x) * (r + x))));
        return (std::max)(Real(0), Real((std::min)(half, y1) - (std::max)(Real(-half), y0)));
    };
    // Breaks where the circle crosses the horizontal sides: analytic in between, with square roots at the ends.
    std::vector<Real> breaks{from, to};
    for (const Real& y : {y0, y1})
        if (abs(y) < r)
            for (const int sign : {-1, 1})
                if (const Real x = sign * sqrt((r - y) * (r + y)); from < x && x < to) breaks.push_back(x);
    std::ranges::sort(breaks);
    boost::math::quadrature::tanh_sinh<Real> quadrature(
        12, Real(1e-60));  // the default end, 1e-10^18 or so, overflows in MPFR
    Real area = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        if (breaks[i] < breaks[i + 1]) area += quadrature.integrate(length, breaks[i], breaks[i + 1], Real(1e-30));
    return static_cast<double>(area);
}

}  // namespace plumb
