#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/interval.h"
#include "core/point.h"

namespace plumb {

/// The smoothness of an integrand inside the cube, and (second use) as a function on the torus, where 0 ≡ 1. The
/// expected slopes follow from it and the method (docs/statistics.md, "Rates").
enum class Smoothness {
    analytic,  ///< all derivatives continuous
    kink,      ///< continuous, first derivative jumps
    root,      ///< continuous, with a vertical tangent, like √x at 0
    jump,      ///< bounded, jumps, or has no limit on the boundary
    singular,  ///< unbounded
};
std::string to_string(Smoothness smoothness);

/// A test problem that carries its exact answers, as decimals of 55 places: values of closed forms, derived in
/// `derivation` and held to two independent quadratures by the claims integrand/*. `value` is defined on the closed
/// cube, so its boundary values are value({0}), value({1}); a singular one is infinite there.
template <int D>
struct Integrand {
    std::string id;       ///< e.g. "exp", "genz/oscillatory-1"
    std::string formula;  ///< as a person writes it
    std::function<double(const Point<D>&)> value;
    std::string integral;                               ///< over [0,1]^D
    std::string variance;                               ///< of f(U), U uniform; "inf" where infinite
    Smoothness smoothness = Smoothness::analytic;       ///< inside the cube
    Smoothness periodic_smoothness = Smoothness::jump;  ///< of the periodic extension (for torus methods)
    Interval bounds{};                                  ///< of the values, where finite
    std::string source;                                 ///< where the integrand comes from
    std::string derivation;                             ///< how ∫ f and ∫ f² were derived, and how checked

    double operator()(const Point<D>& x) const { return value(x); }
    [[nodiscard]] double integral_value() const { return std::stod(integral); }
    [[nodiscard]] double variance_value() const { return std::stod(variance); }  ///< "inf" gives infinity
    /// √E f²: the scale for delta where the integral is zero or tiny.
    [[nodiscard]] double root_mean_square() const;
};

/// All shipped integrands, in the order of the report.
const std::vector<Integrand<1>>& integrands_1d();
const std::vector<Integrand<2>>& integrands_2d();

template <int D>
const std::vector<Integrand<D>>& integrands();
/// The integrand with this id; throws Error naming the nearest one.
template <int D>
const Integrand<D>& find_integrand(std::string_view id);

}  // namespace plumb
