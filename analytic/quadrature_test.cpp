#include "analytic/quadrature_rules.h"

#include "analytic/real.h"

namespace plumb {
namespace {

double sum_of(const Rule<Real>& rule, const auto& f) {
    Real sum = 0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) sum += rule.weight[i] * f(rule.node[i]);
    return static_cast<double>(sum);
}
Real monomial(int power, const Real& x) {
    return pow(x, power);
}

TEST(GaussLegendre, is_exact_up_to_the_degree_2n_minus_1_and_no_further) {
    const Rule<Real> rule = gauss_legendre<Real>(5);
    for (int k = 0; k < 10; ++k)
        EXPECT_LT(std::abs(sum_of(rule, [k](const Real& x) { return Real(monomial(k, x) - Real(1) / (k + 1)); })),
                  1e-75)
            << k;
    // The error of x^{2n} is the integral of the squared monic Legendre polynomial: (n!)^4 / ((2n+1) (2n)!^2).
    const double error = sum_of(rule, [](const Real& x) { return Real(Real(1) / 11 - monomial(10, x)); });
    EXPECT_NEAR(error, std::pow(120., 4) / (11 * std::pow(3628800., 2)), 1e-20);
}

TEST(TanhSinh, integrates_through_a_singular_end) {
    const Rule<Real> rule = tanh_sinh<Real>(40, 120);
    EXPECT_LT(std::abs(sum_of(rule, [](const Real& x) { return Real(1 / sqrt(x) - 2); })), 1e-55);
    EXPECT_LT(std::abs(sum_of(rule, [](const Real& x) { return Real(log(x) + 1); })), 1e-55);
}

TEST(Logarithmic, integrates_a_power_close_to_minus_one) {
    const Rule<Real> rule = logarithmic(gauss_legendre<Real>(80), 600);
    const Real exponent = -Real(9) / 10;
    EXPECT_LT(std::abs(sum_of(rule, [&](const Real& x) { return Real(pow(x, exponent) - 10); })), 1e-55);
}

TEST(NormalQuantile, inverts_the_distribution_function_in_80_digits) {
    using Elementary = formulas::Elementary<Real>;
    for (const double u : {1e-40, 0.001, 0.3, 0.5, 0.9}) {
        const Real z = Elementary::normal_quantile(u);
        const Real round_trip = Elementary::erfc(Real(-z / sqrt(Real(2)))) / 2;
        EXPECT_LT(static_cast<double>(abs(Real(round_trip / u - 1))), 1e-75) << u;
        EXPECT_NEAR(formulas::Elementary<double>::normal_quantile(u), static_cast<double>(z), 1e-14) << u;
    }
}

TEST(QuadratureErrors, are_the_distance_of_what_is_stated) {
    Integrand<1> wrong = find_integrand<1>("linear");  // √E f² = 1/√3, E f² = 1/3
    wrong.integral = "0.5001";
    wrong.variance = "0.08333333333333333333333333333333333333333333333333";
    for (const Quadrature method : {Quadrature::gauss_legendre, Quadrature::tanh_sinh}) {
        const QuadratureError error = quadrature_errors<1>(std::span(&wrong, 1), method)[0];
        const double second = 1 / 12. + 0.5001 * 0.5001;
        EXPECT_NEAR(error.integral, 1e-4 / std::sqrt(second), 1e-12);
        EXPECT_NEAR(error.second_moment, (second - 1 / 3.) / second, 1e-12);
    }
}

TEST(QuadratureErrors, an_unknown_formula_is_refused) {
    Integrand<2> unknown = find_integrand<2>("disk");
    unknown.id = "no-such-formula";
    EXPECT_THROW((void)quadrature_errors<2>(std::span(&unknown, 1), Quadrature::tanh_sinh), std::logic_error);
}

}  // namespace
}  // namespace plumb
