#include "analytic/cell_weight_exact.h"

#include <boost/multiprecision/mpfr.hpp>

namespace plumb {
namespace {

// 800 decimals are 2657 bits: 1 − x is exact for every double x (at most 1074 bits), and the power of it loses
// log2(N) ≤ 64 of the rest, so that the formula may stand as it is printed.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<800>>;

Real g(std::uint64_t n, double x_double) {
    const Real count = n, x = x_double, y = 1 - x;
    return ((count - count * x - x) * pow(x, count - 1) + (count * x + x - 1) * pow(y, count - 1) + 2) / 2;
}

}  // namespace

std::string exact_cell_weight(std::uint64_t n, double x, int digits) {
    return g(n, x).str(digits);
}

double cell_weight_ulps(double found, std::uint64_t n, double x) {
    if (std::isnan(found)) return std::numeric_limits<double>::infinity();
    const Real truth = g(n, x);
    const double ulp = std::ldexp(1.0, std::ilogb(truth.convert_to<double>()) - 52);
    const Real error = abs(Real(found) - truth) / ulp;
    return error.convert_to<double>();
}

}  // namespace plumb
