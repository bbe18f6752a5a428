#include "analytic/cell_weight.h"

#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

void require_sample(std::uint64_t n, double x) {
    if (n == 0) throw Error("a cell weight for 0 samples; at least 1 is needed");
    if (!(x >= 0 && x <= 1)) throw Error(fmt::format("a cell weight at x = {}; x must lie in [0, 1]", x));
}

// ((N+1) x − 1) (1−x)^{N−1}: what the end at 0 takes from (negative) or gives to the cell of a sample at x.
//
// Its own relative error is unbounded at x = 1/(N+1), but its absolute error, the one that matters beside the 1 of g,
// is below 2^-53: with s = N x the term is about (s − 1) e^{-s}, and the rounding of the exponent (a few units of
// s 2^-53) is weighted with s |s − 1| e^{-s} < 1. pow(1 − x, N − 1) would not do: the rounding of 1 − x, 2^-54, is
// multiplied by N.
double end_term(double n, double x) {
    // (1−x)^{N−1} ≤ e^{−(N−1)x}: beyond 60 the term is below 200 e^-60, nothing beside 1. Most of many samples are
    // there.
    if ((n - 1) * x > 60) return 0;
    return std::fma(n + 1, x, -1) * std::exp((n - 1) * std::log1p(-x));
}

}  // namespace

double cell_weight(std::uint64_t n, double x) {
    require_sample(n, x);
    if (n == 1) return 1;
    const double count = static_cast<double>(n);
    // 1 − x is exact for x ≥ 1/2; below, its rounding moves x^{N−1}, which is at most 2^{1−N}, by less than 2^-53.
    return 1 + (end_term(count, x) + end_term(count, 1 - x)) / 2;
}

double stratified_cell_weight(std::uint64_t n, double x) {
    require_sample(n, x);
    if (n == 1) return 1;
    const double count = static_cast<double>(n);
    // The first sample's cell reaches from 0 half-way to its neighbour, whose mean position is 3/(2N).
    // g_s jumps at the strata's edges: fma decides N x < 1 and N x ≥ N − 1 without rounding.
    if (std::fma(count, x, -1) < 0) return (count * x + 1.5) / 2;
    if (std::fma(count, x, 1 - count) >= 0) return (count * (1 - x) + 1.5) / 2;
    return 1;
}

}  // namespace plumb
