#include "analytic/ordered_samples.h"

namespace plumb {
namespace {

const RationalPolynomial x = identity_polynomial();

// ∫ over 0 < x_1 < … < x_{k−1} < x of (j = 0 or j ≥ k: 1; else x_j)
RationalPolynomial below(int k, int j) {
    RationalPolynomial integral = 1;
    for (int i = 1; i < k; ++i) integral = antiderivative(i == j ? integral * x : integral);
    return integral;
}

// ∫ over x < x_{k+1} < … < x_N < 1, likewise
RationalPolynomial above(int n, int k, int j) {
    RationalPolynomial integral = 1;
    for (int i = n; i > k; --i) {
        const RationalPolynomial primitive = antiderivative(i == j ? integral * x : integral);
        integral = primitive(Rational(1)) - primitive;
    }
    return integral;
}

Rational factorial(int n) {
    return n < 2 ? Rational(1) : n * factorial(n - 1);
}

Rational stratum_mean(int n, int k) {
    const Rational from(k, n), to(k + 1, n);
    return n * integral(x, from, to);
}

}  // namespace

RationalPolynomial ordered_moment(int n, int k, int j) {
    const RationalPolynomial moment = factorial(n) * below(k, j) * above(n, k, j);
    return j == k ? moment * x : moment;
}

RationalPolynomial clipped_cell_polynomial(int n) {
    const Rational half(1, 2);
    RationalPolynomial g;
    for (int k = 1; k <= n; ++k) {
        const RationalPolynomial upper =
            k < n ? half * (ordered_moment(n, k, k) + ordered_moment(n, k, k + 1)) : ordered_moment(n, k, 0);
        if (k > 1) g -= half * (ordered_moment(n, k, k - 1) + ordered_moment(n, k, k));
        g += upper;
    }
    return g;
}

RationalPolynomial torus_cell_polynomial(int n) {
    const Rational half(1, 2);
    RationalPolynomial g;
    for (int k = 1; k <= n; ++k) {
        // The neighbours of the first and the last sample lie a period away; a lone sample is its own neighbour.
        const RationalPolynomial next =
            k < n ? ordered_moment(n, k, k + 1) : ordered_moment(n, k, 1) + ordered_moment(n, k, 0);
        const RationalPolynomial previous =
            k > 1 ? ordered_moment(n, k, k - 1) : ordered_moment(n, k, n) - ordered_moment(n, k, 0);
        g += half * (next - previous);
    }
    return g;
}

RationalPolynomial printed_cell_polynomial(int n) {
    return Rational(1, 2) * ((n - n * x - x) * pow(x, n - 1) + (n * x + x - 1) * pow(1 - x, n - 1) + 2);
}

RationalPolynomial printed_periodic_polynomial(int n) {
    const RationalPolynomial a = 1 - x;
    return 1 + Rational(1, 2) * pow(a, n - 2) * (a * (n + x - 1) - n * (n + x - 2));
}

RationalPolynomial stratified_cell_polynomial(int n, int k) {
    const Rational half(1, 2);
    const RationalPolynomial lower = k > 0 ? half * (x + stratum_mean(n, k - 1)) : RationalPolynomial();
    const RationalPolynomial upper = k + 1 < n ? half * (x + stratum_mean(n, k + 1)) : RationalPolynomial(1);
    return n * (upper - lower);
}

RationalPolynomial stratified_torus_cell_polynomial(int n, int k) {
    const Rational previous = k > 0 ? stratum_mean(n, k - 1) : Rational(stratum_mean(n, n - 1) - 1);
    const Rational next = k + 1 < n ? stratum_mean(n, k + 1) : Rational(stratum_mean(n, 0) + 1);
    return Rational(n, 2) * (RationalPolynomial(next) - previous);
}

}  // namespace plumb
