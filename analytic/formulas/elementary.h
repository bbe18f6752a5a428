#pragma once

#include <cmath>
#include <numbers>

namespace plumb::formulas {

// A formula is written once over its number type R: double for the program, multi-precision for its proof. Unqualified
// names below find <cmath> for double and the multi-precision functions by argument-dependent lookup.
using std::abs;
using std::acos;
using std::atan;
using std::cos;
using std::exp;
using std::log;
using std::pow;
using std::sin;
using std::sqrt;

/// What the formulas need beyond <cmath>; analytic/real.h has it for multi-precision.
template <class R>
struct Elementary;

template <>
struct Elementary<double> {
    static constexpr double pi() { return std::numbers::pi; }
    /// Φ⁻¹(u), −∞ at 0 and +∞ at 1.
    static double normal_quantile(double u);
};

template <class R>
R pi() {
    return Elementary<R>::pi();
}

template <class R>
R squared(const R& x) {
    return x * x;
}

}  // namespace plumb::formulas
