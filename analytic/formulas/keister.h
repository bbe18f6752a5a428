#pragma once

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

// [Keister 1996]: ∫ cos‖t‖ e^{−‖t‖²} dt over R^D. With t = Φ⁻¹(u)/√2 on every axis it is ∫ π^{D/2} cos‖t(u)‖ du over
// the unit cube. Towards the faces the integrand oscillates for ever, between ±π^{D/2}: it has no limit there, which
// costs a method what a jump on the faces costs; on the faces themselves it is 0 here.

template <class R>
R keister_coordinate(const R& u) {
    return Elementary<R>::normal_quantile(u) / sqrt(R(2));
}

/// Dawson's integral e^{−x²} ∫_0^x e^{t²} dt = Σ (−1)^n 2^n x^{2n+1} / (2n+1)!!.
template <class R>
R dawson(const R& x) {
    R sum = 0, term = x;
    for (int n = 1; sum + term != sum; ++n) {
        sum += term;
        term *= -2 * x * x / (2 * n + 1);
    }
    return sum;
}

template <class R>
Panels<R> keister_panels() {
    return {{R(0), R(R(1) / 2), Singular::low}, {R(R(1) / 2), R(1), Singular::high}};
}

struct Keister : Formula1D {
    Description about() const {
        return {
            .id = "keister",
            .formula = "sqrt(pi) cos(Phi^-1(x) / sqrt 2)",
            .smoothness = Smoothness::jump,
            .periodic_smoothness = Smoothness::jump,
            .bounds = with_rounding(-1.7724538509055161, 1.7724538509055161),
            .source = "[Keister 1996], Multidimensional quadrature algorithms, D = 1",
            .derivation = "the characteristic function of N(0, 1/2) at 1 and 2: sqrt(pi) e^{-1/4}; pi (1 + e^{-1})/2"};
    }
    template <class R>
    R value(const std::array<R, 1>& u) const {
        if (u[0] <= 0 || u[0] >= 1) return 0;
        return sqrt(pi<R>()) * cos(keister_coordinate(u[0]));
    }
    template <class R>
    R integral() const {
        return sqrt(pi<R>()) * exp(R(-R(1) / 4));
    }
    template <class R>
    R second_moment() const {
        return pi<R>() * (1 + exp(R(-1))) / 2;
    }
    template <class R>
    Panels<R> panels_x() const {
        return keister_panels<R>();
    }
};

struct Keister2D : Formula2D {
    Description about() const {
        return {.id = "keister-2d",
                .formula = "pi cos(sqrt((Phi^-1(x)^2 + Phi^-1(y)^2) / 2))",
                .smoothness = Smoothness::jump,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(-std::numbers::pi, std::numbers::pi),
                .source = "[Keister 1996], Multidimensional quadrature algorithms, D = 2",
                .derivation =
                    "int_0^inf 2 r e^{-r^2} cos(k r) dr = 1 - k F(k/2) by parts, F Dawson's integral: "
                    "pi (1 - F(1/2)); pi^2 (1 + 1 - 2 F(1))/2"};
    }
    template <class R>
    R value(const std::array<R, 2>& u) const {
        for (const R& axis : u)
            if (axis <= 0 || axis >= 1) return 0;
        return pi<R>() * cos(sqrt(R(squared(keister_coordinate(u[0])) + squared(keister_coordinate(u[1])))));
    }
    template <class R>
    R integral() const {
        return pi<R>() * (1 - dawson(R(R(1) / 2)));
    }
    template <class R>
    R second_moment() const {
        return squared(pi<R>()) * (1 - dawson(R(1)));
    }
    template <class R>
    Panels<R> panels_x() const {
        return keister_panels<R>();
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return keister_panels<R>();
    }
};

}  // namespace plumb::formulas
