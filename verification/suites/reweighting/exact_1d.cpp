#include "analytic/ordered_samples.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

using PolynomialOfN = std::function<RationalPolynomial(int n)>;
using PolynomialOfStratum = std::function<RationalPolynomial(int n, int k)>;

const RationalPolynomial x = identity_polynomial();

// A polynomial for each N ≥ first.
struct Polynomials {
    PolynomialOfN of;
    int first = 1;
};

// Coefficient by coefficient, to N = 8 (20 in full).
Verdict same_polynomials(const Polynomials& subject, const PolynomialOfN& truth, const Run& run) {
    const auto& [found, from] = subject;
    const int to = run.pick(8, 20);
    for (int n = from; n <= to; ++n)
        if (const auto a = found(n), b = truth(n); a != b)
            return exactly(false, static_cast<std::uint64_t>(n - from + 1),
                           fmt::format("N = {}: {} is not {}", n, to_string(a), to_string(b)));
    return exactly(true, static_cast<std::uint64_t>(to - from + 1), fmt::format("equal for N = {} … {}", from, to));
}

Verdict same_in_all_strata(const PolynomialOfStratum& found, const PolynomialOfStratum& truth, const Run& run) {
    const int last = run.pick(8, 20);
    std::uint64_t cases = 0;
    for (int n = 2; n <= last; ++n)
        for (int k = 0; k < n; ++k, ++cases)
            if (const auto a = found(n, k), b = truth(n, k); a != b)
                return exactly(false, cases + 1,
                               fmt::format("N = {}, stratum {}: {} is not {}", n, k, to_string(a), to_string(b)));
    return exactly(true, cases, fmt::format("equal in every stratum for N = 2 … {}", last));
}

RationalPolynomial one(int) {
    return 1;
}
RationalPolynomial one_in_stratum(int, int) {
    return 1;
}

RationalPolynomial stratified_closed_form(int n, int k) {
    if (k == 0) return Rational(1, 2) * (n * x + Rational(3, 2));
    if (k == n - 1) return Rational(1, 2) * (n * (1 - x) + Rational(3, 2));
    return 1;
}

// The verdict on whether g averages to 1, as E of weights that sum to 1 must, for N = 2 … 8 (40 in full).
Verdict integrates_to_one(const PolynomialOfN& g, const Run& run) {
    const int last = run.pick(8, 40);
    for (int n = 2; n <= last; ++n)
        if (const Rational mass = integral(g(n), 0, 1); mass != 1)
            return exactly(false, static_cast<std::uint64_t>(n - 1),
                           fmt::format("N = {}: the integral is {}", n, mass.str()));
    return exactly(true, static_cast<std::uint64_t>(last - 1), fmt::format("the integral is 1 for N = 2 … {}", last));
}

// Neither an integral of 1 nor symmetry, at every N: not the expectation of any scheme that has no preferred side.
Verdict is_no_expected_cell(const PolynomialOfN& g, const Run& run) {
    const int last = run.pick(8, 20);
    for (int n = 2; n <= last; ++n) {
        const bool symmetric = g(n) == g(n)(1 - x), normalised = integral(g(n), 0, 1) == 1;
        if (symmetric || normalised)
            return exactly(false, static_cast<std::uint64_t>(n - 1),
                           fmt::format("N = {}: symmetric {}, integral {}", n, symmetric, integral(g(n), 0, 1).str()));
    }
    return exactly(true, static_cast<std::uint64_t>(last - 1),
                   fmt::format("for N = 2 … {} the integral is not 1 (5/6 at N = 2), nor is it symmetric", last));
}

RationalPolynomial with_exponents_n(int n) {
    return Rational(1, 2) * ((n - n * x - x) * pow(x, n) + (n * x + x - 1) * pow(1 - x, n) + 2);
}
RationalPolynomial with_another_end_term(int n) {
    return Rational(1, 2) * ((n - n * x - x) * pow(x, n - 1) + (n * x - x + 1) * pow(1 - x, n - 1) + 2);
}

void add_clipped_cells(Catalogue& catalogue) {
    catalogue.add(
        {.id = "reweighting/g-1d/exact",
         .statement =
             "N times the expected clipped cell of a sample at x is g_N(x) = [(N−Nx−x)x^{N−1} + (Nx+x−1)(1−x)^{N−1} "
             "+ 2]/2, coefficient by coefficient.",
         .source = "[thesis, eq. 4.6]",
         .kind = Kind::exact,
         .trial = {
             [](const Polynomials& g, const Run& run) { return same_polynomials(g, clipped_cell_polynomial, run); },
             {printed_cell_polynomial},
             {{"n-minus-1", "g of N − 1 samples", {[](int n) { return printed_cell_polynomial(n - 1); }, 2}},
              {"exponents-n", "powers N in place of N − 1", {with_exponents_n}}}}});
    catalogue.add(
        {.id = "reweighting/g-1d/integral",
         .statement = "∫ g_N = 1: the expected weights of N samples sum to 1.",
         .source = "ours, analytic/ordered_samples.h",
         .kind = Kind::exact,
         .trial = {integrates_to_one,
                   printed_cell_polynomial,
                   {{"sign-of-the-end-term", "(Nx − x + 1) in place of (Nx + x − 1)", with_another_end_term}}}});
    catalogue.add(
        {.id = "reweighting/g-stratified/exact",
         .statement = "With one jittered sample in each of N ≥ 2 strata, N times the expected clipped cell is 1 in "
                      "inner strata, (Nx + 3/2)/2 in the first and (N(1−x) + 3/2)/2 in the last.",
         .source = "ours, analytic/ordered_samples.h",
         .kind = Kind::exact,
         .trial = {
             [](const PolynomialOfStratum& g, const Run& run) {
                 return same_in_all_strata(g, stratified_cell_polynomial, run);
             },
             stratified_closed_form,
             {{"g-of-iid-samples", "g_N of i.i.d. samples", [](int n, int) { return printed_cell_polynomial(n); }},
              {"neighbour-at-its-stratum-edge", "the neighbour at 1/N in place of its mean 3/(2N)",
               [](int n, int k) { return k == 0 ? Rational(1, 2) * (n * x + 1) : stratified_closed_form(n, k); }}}}});
}

void add_torus_cells(Catalogue& catalogue) {
    catalogue.add(
        {.id = "reweighting/torus-cells-1d/exact",
         .statement = "On the circle the expected cell of each of N i.i.d. uniform samples is 1/N wherever it lies.",
         .source = "ours, analytic/ordered_samples.h; against [thesis, appendix A.2]",
         .kind = Kind::exact,
         .trial = {[](const Polynomials& g, const Run& run) { return same_polynomials(g, one, run); },
                   {torus_cell_polynomial},
                   {{"appendix-a2",
                     "the integrand that the thesis prints for periodic samples",
                     {printed_periodic_polynomial, 2}},
                    {"clipped-called-periodic", "cells clipped to [0,1]", {clipped_cell_polynomial}}}}});
    catalogue.add({.id = "reweighting/torus-cells-1d/appendix-a2",
                   .statement =
                       "The integrand printed for periodically augmented samples is the expectation of no weights that "
                       "sum to 1: for N = 2 … 8 its integral is not 1, and it is not symmetric.",
                   .source = "ours, against [thesis, appendix A.2]",
                   .kind = Kind::exact,
                   .trial = {is_no_expected_cell,
                             printed_periodic_polynomial,
                             {{"a-true-expectation", "g_N, which is the expectation of weights that sum to 1",
                               printed_cell_polynomial}}}});
    catalogue.add({.id = "reweighting/stratified-torus-cells/exact",
                   .statement = "With one jittered sample in each of N ≥ 2 strata, the expected cell on the circle is "
                                "1/N in every stratum.",
                   .source = "ours, analytic/ordered_samples.h",
                   .kind = Kind::exact,
                   .trial = {[](const PolynomialOfStratum& g, const Run& run) {
                                 return same_in_all_strata(g, one_in_stratum, run);
                             },
                             stratified_torus_cell_polynomial,
                             {{"clipped-called-periodic", "cells clipped to [0,1]", stratified_cell_polynomial}}}});
}

}  // namespace

void add_reweighting_exact_1d(Catalogue& catalogue) {
    add_clipped_cells(catalogue);
    add_torus_cells(catalogue);
}

}  // namespace plumb::suites
