#include "estimators/warp_1d.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace plumb {

Function<1> warped(Function<1> f, Warp1D warp) {
    return [f = std::move(f), warp = std::move(warp)](const Point<1>& u) {
        const double x = warp.inverse_cdf(u[0]);
        return f({x}) / warp.pdf(x);
    };
}

Warp1D linear_warp(double a) {
    if (!(a > 0 && a < 2))
        throw Error(fmt::format("a linear density of value {} at 0; values between 0 and 2 are accepted", a));
    // u = a x + (1 − a) x², solved by the form that does not cancel at a = 1.
    return {[a](double u) { return std::min(1.0, 2 * u / (a + std::sqrt(a * a + 4 * (1 - a) * u))); },
            [a](double x) { return a + 2 * (1 - a) * x; }};
}

}  // namespace plumb
