#include "analytic/ordered_samples.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

const RationalPolynomial x = identity_polynomial();

TEST(OrderedSamples, DensitiesSumToN) {
    for (int n = 1; n <= 6; ++n) {
        RationalPolynomial sum;
        for (int k = 1; k <= n; ++k) sum += ordered_moment(n, k, 0);
        EXPECT_EQ(sum, RationalPolynomial(n));
    }
}

TEST(OrderedSamples, MeansAreThoseOfTheBetaDistribution) {
    // E x_j = j/(N+1), whichever sample carries the outer integral
    for (int k = 1; k <= 5; ++k)
        for (int j = 1; j <= 5; ++j) EXPECT_EQ(integral(ordered_moment(5, k, j), 0, 1), Rational(j, 6));
}

TEST(OrderedSamples, ReproduceTheClosedForm) {
    for (int n = 1; n <= 8; ++n) EXPECT_EQ(clipped_cell_polynomial(n), printed_cell_polynomial(n)) << n;
}

TEST(OrderedSamples, TorusCellsHaveMeanOneOverNEverywhere) {
    for (int n = 1; n <= 8; ++n) EXPECT_EQ(torus_cell_polynomial(n), RationalPolynomial(1)) << n;
}

TEST(OrderedSamples, PrintedPeriodicFormIsTheSimplifiedOne) {
    // The numerator as appendix A.2 prints it, with (1/(1−x))^n (1−x)^n = 1, against 2 (x−1)² times the simplified
    // form.
    for (int n = 2; n <= 8; ++n) {
        const RationalPolynomial first = (n % 2 == 0 ? -n : n) * pow(x - 1, n) * (n + x - 2);
        const RationalPolynomial second = (x - 1) * (n * x + 2 * x - 1 - pow(1 - x, n) * (n + x - 1) - (n * x + 1));
        EXPECT_EQ(first + second, 2 * pow(x - 1, 2) * printed_periodic_polynomial(n)) << n;
    }
}

TEST(OrderedSamples, StratifiedCells) {
    EXPECT_EQ(stratified_cell_polynomial(4, 0), (4 * x + Rational(3, 2)) * Rational(1, 2));
    EXPECT_EQ(stratified_cell_polynomial(4, 1), RationalPolynomial(1));
    EXPECT_EQ(stratified_cell_polynomial(4, 3), (4 * (1 - x) + Rational(3, 2)) * Rational(1, 2));
    for (int n = 2; n <= 5; ++n)
        for (int k = 0; k < n; ++k) EXPECT_EQ(stratified_torus_cell_polynomial(n, k), RationalPolynomial(1));
}

}  // namespace
}  // namespace plumb
