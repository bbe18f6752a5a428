#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <string>
#include <vector>

namespace plumb {

/// Exact fractions: what the evidence kind `exact` computes in.
using Rational = boost::multiprecision::cpp_rational;

/// A polynomial in one variable with rational coefficients, lowest power first, without trailing zeros:
/// two polynomials are equal exactly when they are the same function.
class RationalPolynomial {
public:
    RationalPolynomial() = default;  ///< zero
    explicit RationalPolynomial(std::vector<Rational> coefficients);
    RationalPolynomial(const Rational& constant);  // implicit, so that p + 1 and 2 * p read as in mathematics
    RationalPolynomial(int constant);

    [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.size()) - 1; }  ///< −1 for zero
    [[nodiscard]] Rational coefficient(int power) const;                                     ///< 0 beyond the degree
    [[nodiscard]] Rational operator()(const Rational& x) const;
    /// The composition this ∘ inner.
    [[nodiscard]] RationalPolynomial operator()(const RationalPolynomial& inner) const;

    RationalPolynomial& operator+=(const RationalPolynomial& other);
    RationalPolynomial& operator-=(const RationalPolynomial& other);
    RationalPolynomial& operator*=(const RationalPolynomial& other);
    friend RationalPolynomial operator+(RationalPolynomial a, const RationalPolynomial& b) { return a += b; }
    friend RationalPolynomial operator-(RationalPolynomial a, const RationalPolynomial& b) { return a -= b; }
    friend RationalPolynomial operator*(RationalPolynomial a, const RationalPolynomial& b) { return a *= b; }
    friend RationalPolynomial operator-(const RationalPolynomial& a) { return RationalPolynomial() -= a; }
    friend bool operator==(const RationalPolynomial&, const RationalPolynomial&) = default;

private:
    void drop_trailing_zeros();
    std::vector<Rational> coefficients_;
};

/// The polynomial x.
RationalPolynomial identity_polynomial();
RationalPolynomial pow(const RationalPolynomial& base, int exponent);  ///< exponent ≥ 0
RationalPolynomial derivative(const RationalPolynomial& p);
RationalPolynomial antiderivative(const RationalPolynomial& p);  ///< the one that vanishes at 0
Rational integral(const RationalPolynomial& p, const Rational& from, const Rational& to);

/// The polynomial as a person writes it, highest power first: "3/2 x^2 - x + 1".
std::string to_string(const RationalPolynomial& p);

}  // namespace plumb
