#pragma once

#include "analytic/rational.h"

namespace plumb {

/// The expected cell lengths of random samples x_1 < … < x_N, by integration over the ordered simplex in rational
/// polynomials: the truth for the closed forms, derived without them. A cell length is linear in the positions of at
/// most three samples, so the integrals over the samples below and above x separate, and each is a chain of
/// antiderivatives in one variable.

/// N! ∫ x_j over all samples but x_k = x, 1 ≤ j, k ≤ N: the density of the k-th sample times the conditional mean of
/// the j-th, as a polynomial in x. With j = 0 the density itself.
RationalPolynomial ordered_moment(int n, int k, int j);

/// N E[|V| given a sample at x] for N i.i.d. uniform samples, cells clipped to [0,1]: g_N.
RationalPolynomial clipped_cell_polynomial(int n);

/// N E[|V| given a sample at x] for cells of the circle [0,1), 0 ≡ 1: the constant 1.
RationalPolynomial torus_cell_polynomial(int n);

/// g_N as the thesis prints it: [(N − Nx − x) x^{N−1} + (Nx + x − 1)(1 − x)^{N−1} + 2]/2 [thesis, eq. 4.6].
RationalPolynomial printed_cell_polynomial(int n);

/// What the thesis prints as the same for periodically augmented samples [thesis, appendix A.2], simplified for integer
/// N with a = 1 − x: 1 + a^{N−2} [a (N + x − 1) − N (N + x − 2)]/2. Two samples or more (at N = 1 it is no polynomial).
RationalPolynomial printed_periodic_polynomial(int n);

/// N E[|V| given x] of the sample in stratum k = 0 … N−1, one jittered sample in each of N ≥ 2 equal strata; valid for
/// x in that stratum.
RationalPolynomial stratified_cell_polynomial(int n, int k);
RationalPolynomial stratified_torus_cell_polynomial(int n, int k);

}  // namespace plumb
