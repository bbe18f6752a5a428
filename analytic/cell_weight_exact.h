#pragma once

#include <cstdint>
#include <string>

namespace plumb {

/// g_N(x) of [thesis, eq. 4.6] by MPFR, correct to `digits` significant decimals (at most 400); x is taken exactly.
std::string exact_cell_weight(std::uint64_t n, double x, int digits = 50);

/// |found − g_N(x)| in units in the last place of g_N(x), by MPFR; infinite for NaN.
double cell_weight_ulps(double found, std::uint64_t n, double x);

}  // namespace plumb
