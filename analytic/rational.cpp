#include "analytic/rational.h"

#include <algorithm>
#include <stdexcept>

namespace plumb {

RationalPolynomial::RationalPolynomial(std::vector<Rational> coefficients) : coefficients_(std::move(coefficients)) {
    drop_trailing_zeros();
}
RationalPolynomial::RationalPolynomial(const Rational& constant)
    : RationalPolynomial(std::vector<Rational>{constant}) {}
RationalPolynomial::RationalPolynomial(int constant) : RationalPolynomial(Rational(constant)) {}

void RationalPolynomial::drop_trailing_zeros() {
    while (!coefficients_.empty() && coefficients_.back() == 0) coefficients_.pop_back();
}

Rational RationalPolynomial::coefficient(int power) const {
    if (power < 0) throw std::logic_error("a polynomial has no negative powers");
    return power <= degree() ? coefficients_[static_cast<std::size_t>(power)] : Rational(0);
}

Rational RationalPolynomial::operator()(const Rational& x) const {
    Rational value = 0;
    for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) value = value * x + *c;
    return value;
}

RationalPolynomial RationalPolynomial::operator()(const RationalPolynomial& inner) const {
    RationalPolynomial value;
    for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) value = value * inner + *c;
    return value;
}

RationalPolynomial& RationalPolynomial::operator+=(const RationalPolynomial& other) {
    coefficients_.resize(std::max(coefficients_.size(), other.coefficients_.size()));
    for (std::size_t i = 0; i < other.coefficients_.size(); ++i) coefficients_[i] += other.coefficients_[i];
    drop_trailing_zeros();
    return *this;
}

RationalPolynomial& RationalPolynomial::operator-=(const RationalPolynomial& other) {
    coefficients_.resize(std::max(coefficients_.size(), other.coefficients_.size()));
    for (std::size_t i = 0; i < other.coefficients_.size(); ++i) coefficients_[i] -= other.coefficients_[i];
    drop_trailing_zeros();
    return *this;
}

RationalPolynomial& RationalPolynomial::operator*=(const RationalPolynomial& other) {
    std::vector<Rational> product(coefficients_.size() + other.coefficients_.size());
    for (std::size_t i = 0; i < coefficients_.size(); ++i)
        for (std::size_t j = 0; j < other.coefficients_.size(); ++j)
            product[i + j] += coefficients_[i] * other.coefficients_[j];
    coefficients_ = std::move(product);
    drop_trailing_zeros();
    return *this;
}

RationalPolynomial identity_polynomial() {
    return RationalPolynomial(std::vector<Rational>{0, 1});
}

RationalPolynomial pow(const RationalPolynomial& base, int exponent) {
    if (exponent < 0) throw std::logic_error("a power of a polynomial needs an exponent >= 0");
    RationalPolynomial power = 1;
    for (int i = 0; i < exponent; ++i) power *= base;
    return power;
}

RationalPolynomial derivative(const RationalPolynomial& p) {
    std::vector<Rational> coefficients;
    for (int k = 1; k <= p.degree(); ++k) coefficients.push_back(k * p.coefficient(k));
    return RationalPolynomial(std::move(coefficients));
}

RationalPolynomial antiderivative(const RationalPolynomial& p) {
    std::vector<Rational> coefficients{0};
    for (int k = 0; k <= p.degree(); ++k) coefficients.push_back(p.coefficient(k) / (k + 1));
    return RationalPolynomial(std::move(coefficients));
}

Rational integral(const RationalPolynomial& p, const Rational& from, const Rational& to) {
    const RationalPolynomial primitive = antiderivative(p);
    return primitive(to) - primitive(from);
}

std::string to_string(const RationalPolynomial& p) {
    std::string text;
    for (int k = p.degree(); k >= 0; --k) {
        const Rational c = p.coefficient(k);
        if (c == 0) continue;
        const Rational magnitude = c < 0 ? Rational(-c) : c;
        text += text.empty() ? (c < 0 ? "-" : "") : (c < 0 ? " - " : " + ");
        if (magnitude != 1 || k == 0) text += magnitude.str() + (k > 0 ? " " : "");
        if (k > 0) text += k == 1 ? "x" : "x^" + std::to_string(k);
    }
    return text.empty() ? "0" : text;
}

}  // namespace plumb
