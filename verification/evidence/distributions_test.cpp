#include "verification/evidence/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumb {
namespace {

// Published tables: Abramowitz & Stegun 26.2 (normal), 26.8 (chi-square); NIST e-Handbook 7.2.4.1 (Clopper–Pearson).
TEST(Normal, AgreesWithTables) {
    EXPECT_NEAR(normal_upper_quantile(0.025), 1.959963984540054, 1e-14);
    EXPECT_NEAR(normal_upper_quantile(1e-9), 5.997807015007687, 1e-13);
    EXPECT_NEAR(normal_two_sided_tail(3), 0.002699796063260, 1e-14);
}

TEST(Normal, TailsSurviveFarOut) {
    EXPECT_GT(normal_two_sided_tail(30), 0);  // 1 − cdf would be 0 beyond 8.3
    EXPECT_NEAR(normal_two_sided_tail(30) / 9.813e-198, 1, 1e-3);
}

TEST(Student, AgreesWithTables) {
    EXPECT_NEAR(student_upper_quantile(0.025, 10), 2.228138852, 1e-9);
    EXPECT_NEAR(student_two_sided_tail(2.228138852, 10), 0.05, 1e-9);
    EXPECT_NEAR(student_two_sided_tail(3, std::numeric_limits<double>::infinity()), 0.002699796063260, 1e-14);
}

TEST(ChiSquare, AgreesWithTables) {
    EXPECT_NEAR(chi_square_lower_tail(3.940299, 10), 0.05, 1e-7);
    EXPECT_NEAR(chi_square_upper_quantile(0.05, 10), 18.307038, 1e-6);
    EXPECT_NEAR(chi_square_upper_quantile(0.001, 1), 10.827566, 1e-6);
    EXPECT_NEAR(chi_square_tail(18.307038, 10), 0.05, 1e-8);
    EXPECT_NEAR(chi_square_tail(2, 2), std::exp(-1.0), 1e-15);  // exact: exp(−x/2)
}

TEST(Noncentrality, InvertsTheNoncentralDistribution) {
    // With 1 degree of freedom X = (Z + sqrt(nc))², so P(X ≤ x) = Φ(√x − √nc) − Φ(−√x − √nc).
    const double x = 4, beta = 0.01, nc = noncentrality_upper_bound(x, 1, beta);
    const auto phi = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
    EXPECT_NEAR(phi(2 - std::sqrt(nc)) - phi(-2 - std::sqrt(nc)), beta, 1e-9);
}

TEST(Noncentrality, IsZeroWhereEvenTheCentralOneIsTooLarge) {
    EXPECT_EQ(noncentrality_upper_bound(0.5, 30, 0.01), 0);
}

TEST(Noncentrality, HasABoundHoweverFarOut) {
    for (const double x : {1e7, 1.01e8, 1e12, 1e18}) {
        const double bound = noncentrality_upper_bound(x, 3, 0.01), root = std::sqrt(x) + 2.3263478740408408;
        EXPECT_NEAR(bound / (root * root), 1, 1e-6) << x;
    }
}

TEST(ClopperPearson, AgreesWithThePublishedExample) {
    const Interval p = clopper_pearson(4, 20, 0.05);  // NIST 7.2.4.1: 90 % interval of 4 in 20
    EXPECT_NEAR(p.low, 0.071354, 1e-6);
    EXPECT_NEAR(p.high, 0.401029, 1e-6);
    EXPECT_EQ(clopper_pearson(0, 10, 0.05).low, 0);
    EXPECT_NEAR(clopper_pearson(0, 10, 0.05).high, 1 - std::pow(0.05, 0.1), 1e-14);
    EXPECT_EQ(clopper_pearson(10, 10, 0.05).high, 1);
}

}  // namespace
}  // namespace plumb
