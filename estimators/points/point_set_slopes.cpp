#include "estimators/points/point_set_slopes.h"

#include <cmath>

namespace plumb {
namespace {

constexpr Interval exponent(double e) {
    return {e, e};
}

}  // namespace

// The variance is n^-2 times the sum of the variances within the n cells, of side h = n^(-1/D). Where f is Lipschitz
// each is O(h²): -1 - 2/D, kinks included. A jump runs through O(n h) cells, each of variance O(1): -1 - 1/D.
template <int D>
std::optional<Interval> stratified_slope(const Integrand<D>& f) {
    switch (f.smoothness) {
        case Smoothness::analytic:
        case Smoothness::kink: return exponent(-1 - 2.0 / D);
        case Smoothness::jump: return exponent(-1 - 1.0 / D);
        case Smoothness::root:
        case Smoothness::singular: break;
    }
    return {};
}

// The part of f that is a sum of functions of one axis each is stratified in 1D: -3, or -2 with jumps. What is left
// keeps its Monte Carlo rate [Stein 1987], -1, unless nothing is left.
std::optional<Interval> latin_hypercube_slope(const Integrand<2>& f) {
    switch (f.smoothness) {
        case Smoothness::analytic:
        case Smoothness::kink: return Interval{-3, -1};
        case Smoothness::jump: return Interval{-2, -1};
        case Smoothness::root:
        case Smoothness::singular: break;
    }
    return {};
}

// The additive part as Latin hypercube: -3, or -2 with jumps. What is left is worse than stratified, -2: all m = √n
// cells of a row share their place along x, so their linear terms, O(1/m) each, add up before they are squared. Over
// the m rows the places are a permutation, which cancels the mean of f_x but not how its row averages R(y) vary: the
// variance is n^-2 · m · m² · Var R / (12 m²) = n^-1.5 Var R / 12, and the same along y. Jumps: the cells crossed, -1.5
// at an angle, -2 parallel to an axis.
std::optional<Interval> multi_jittered_slope(const Integrand<2>& f) {
    switch (f.smoothness) {
        case Smoothness::analytic:
        case Smoothness::kink: return Interval{-3, -1.5};
        case Smoothness::jump: return Interval{-2, -1.5};
        case Smoothness::root:
        case Smoothness::singular: break;
    }
    return {};
}

// 1D, n = 2^k: the regular grid, shifted or not. By Fourier series the error gathers the coefficients of f at multiples
// of n, which fall like 1/m for a jump of the periodic extension, 1/m² for a kink: MSE -2 and -4.
// 2D: Koksma-Hlawka with discrepancies O(n^-1 log² n) gives -2 for integrands of bounded variation in the sense of
// Hardy and Krause: those without jumps. That is attained where f does not match across the borders of the square.
template <int D>
std::optional<Interval> low_discrepancy_slope(const Integrand<D>& f) {
    if (f.smoothness == Smoothness::singular) return {};
    if (D == 1 && f.periodic_smoothness == Smoothness::jump) return exponent(-2);
    if (D == 1 && f.periodic_smoothness == Smoothness::kink) return exponent(-4);
    if (D == 2 && f.smoothness != Smoothness::jump && f.periodic_smoothness == Smoothness::jump) return exponent(-2);
    return {};
}

// 1D, n = 2^k: digits from the k-th on are independent between points, so this is stratified sampling.
// 2D: the variance is at most a constant times 1/n times the energy of f in the Haar wavelets on boxes 2^-a × 2^-b with
// a + b >= log2 n [Owen 1997]. Along an oblique jump or kink a box that is crossed holds the crossing in a square of
// side s = 2^-max(a,b); 1/s boxes are crossed, each coefficient is 2^((a+b)/2) s² times the height there, O(1) for a
// jump and O(s) for a kink. The energy peaks at a = b, at n^-1/2 and n^-3/2: MSE -1.5 and -2.5. Parallel to an axis the
// wavelets resolve it: -2 and -3. Smooth integrands: -3, times log n, whose
// own exponent is 1/ln n: -2.64 at n = 16, -2.93 at a million.
template <int D>
std::optional<Interval> owen_slope(const Integrand<D>& f) {
    if (D == 1) return stratified_slope(f);
    switch (f.smoothness) {
        case Smoothness::analytic: return Interval{-3, -2.64};
        case Smoothness::kink: return Interval{-3, -2.5};
        case Smoothness::jump: return Interval{-2, -1.5};
        case Smoothness::root:
        case Smoothness::singular: break;
    }
    return {};
}

template std::optional<Interval> stratified_slope(const Integrand<1>&);
template std::optional<Interval> stratified_slope(const Integrand<2>&);
template std::optional<Interval> low_discrepancy_slope(const Integrand<1>&);
template std::optional<Interval> low_discrepancy_slope(const Integrand<2>&);
template std::optional<Interval> owen_slope(const Integrand<1>&);
template std::optional<Interval> owen_slope(const Integrand<2>&);

}  // namespace plumb
