#include "analytic/rational.h"

namespace plumb {
namespace {

const RationalPolynomial x = identity_polynomial();

TEST(RationalPolynomial, arithmetic_follows_the_ring_laws) {
    EXPECT_EQ((x + 1) * (x - 1), pow(x, 2) - 1);
    EXPECT_EQ(pow(x + 1, 3), pow(x, 3) + 3 * pow(x, 2) + 3 * x + 1);
    EXPECT_EQ(-(x - 2), 2 - x);
    EXPECT_EQ(x - x, RationalPolynomial());
    EXPECT_EQ(0 * x, RationalPolynomial());
}

TEST(RationalPolynomial, degree_counts_no_vanished_terms) {
    EXPECT_EQ(RationalPolynomial().degree(), -1);
    EXPECT_EQ(RationalPolynomial(5).degree(), 0);
    EXPECT_EQ((pow(x, 4) + x - pow(x, 4)).degree(), 1);
    EXPECT_EQ(pow(x, 2).coefficient(7), 0);
}

TEST(RationalPolynomial, evaluates_and_composes) {
    const RationalPolynomial p = 2 * pow(x, 2) - x + 3;
    EXPECT_EQ(p(Rational(1, 2)), 3);
    EXPECT_EQ(p(1 - x), 2 * pow(x, 2) - 3 * x + 4);
}

TEST(RationalPolynomial, differentiates_and_integrates) {
    const RationalPolynomial p = 7 * pow(x, 6) - 2 * x + 5;
    EXPECT_EQ(derivative(p), 42 * pow(x, 5) - 2);
    EXPECT_EQ(derivative(antiderivative(p)), p);
    EXPECT_EQ(integral(p, 0, 1), 5);
    EXPECT_EQ(integral(pow(x, 2), Rational(1, 2), 1), Rational(7, 24));
    EXPECT_EQ(integral(RationalPolynomial(), 0, 1), 0);
}

TEST(RationalPolynomial, beta_integrals_are_exact) {  // ∫ x^a (1−x)^b = a! b! / (a+b+1)!
    EXPECT_EQ(integral(pow(x, 10) * pow(1 - x, 10), 0, 1), Rational(1, 3879876));
}

TEST(RationalPolynomial, prints_as_a_person_writes) {
    EXPECT_EQ(to_string(Rational(3, 2) * pow(x, 2) - x + 1), "3/2 x^2 - x + 1");
    EXPECT_EQ(to_string(-x), "-x");
    EXPECT_EQ(to_string(RationalPolynomial()), "0");
}

}  // namespace
}  // namespace plumb
