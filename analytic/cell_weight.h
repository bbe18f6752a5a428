#pragma once

#include <cstdint>

namespace plumb {

/// g_N(x) = N E[|V| given that one of N i.i.d. uniform samples of [0,1] lies at x], V its Voronoi cell clipped to [0,1]
/// [thesis, eq. 4.6]. Between 1/2 (at the ends, N ≥ 2) and 5/4. Relative error ≤ 8 ulp for N ≤ 10^9 and every double x.
/// Throws Error for N = 0 or x outside [0,1].
double cell_weight(std::uint64_t n, double x);

/// g_s(x), the same for one jittered sample in each of N equal strata: 1 inside, (N x + 3/2)/2 in the first stratum,
/// mirrored in the last. With N = 1 the only cell is [0,1] and g_s is 1. Throws as cell_weight does.
double stratified_cell_weight(std::uint64_t n, double x);

}  // namespace plumb
