#pragma once

#include <span>
#include <string>
#include <vector>

#include "analytic/integrand.h"

namespace plumb {

/// Two quadratures with nothing in common but where an integrand is cut: Gauss–Legendre (in log x at singular ends) and
/// tanh-sinh. 1D in 80 digits, good to 1e-50; 2D in 34 digits, good to 1e-15.
enum class Quadrature { gauss_legendre, tanh_sinh };
std::string to_string(Quadrature method);

/// The distance of an integrand's stated answers from a quadrature of the formula of its id.
struct QuadratureError {
    std::string id;
    double integral;  ///< |stated − found| / √E f²; over |integral| where the variance is stated to be infinite
    double second_moment;  ///< of variance + integral², likewise over E f²; 0 where stated to be infinite
};
template <int D>
std::vector<QuadratureError> quadrature_errors(std::span<const Integrand<D>> stated, Quadrature method);

/// The value at x of the formula of this id, computed in multi-precision and rounded once.
template <int D>
double correctly_rounded(std::string_view id, const Point<D>& x);

}  // namespace plumb
