#pragma once

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

/// I₀(x) = Σ (x²/4)^k / k!².
template <class R>
R bessel_i0(const R& x) {
    const R quarter = x * x / 4;
    R sum = 0, term = 1;
    for (int k = 1; sum + term != sum; ++k) {
        sum += term;
        term *= quarter / (R(k) * k);
    }
    return sum;
}

struct PeriodicExponential : Formula1D {
    Description about() const {
        return {.id = "periodic-exp",
                .formula = "exp(sin(2 pi x))",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::analytic,
                .bounds = with_rounding(1 / std::numbers::e, std::numbers::e),
                .source = "ours",
                .derivation = "I_0(t) is the mean of exp(t sin) over a period: I_0(1) and I_0(2)"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return exp(sin(R(2 * pi<R>() * x[0])));
    }
    template <class R>
    R integral() const {
        return bessel_i0(R(1));
    }
    template <class R>
    R second_moment() const {
        return bessel_i0(R(2));
    }
    template <class R>
    Panels<R> panels_x() const {
        return equal_panels<R>(4);
    }
};

struct PeriodicRational : Formula1D {
    Description about() const {
        return {.id = "periodic-rational",
                .formula = "1 / (5/4 + cos(2 pi x))",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::analytic,
                .bounds = with_rounding(4. / 9, 4),
                .source = "ours",
                .derivation =
                    "residues: int 1/(a + cos) = (a^2 - 1)^{-1/2} = 4/3, and minus its derivative by a, "
                    "a (a^2 - 1)^{-3/2} = 80/27, at a = 5/4"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return 1 / (R(5) / 4 + cos(R(2 * pi<R>() * x[0])));
    }
    template <class R>
    R integral() const {
        return R(4) / 3;
    }
    template <class R>
    R second_moment() const {
        return R(80) / 27;
    }
    template <class R>
    Panels<R> panels_x() const {
        return equal_panels<R>(8);
    }
};

struct PeriodicExponential2D : Formula2D {
    Description about() const {
        return {.id = "periodic-exp-2d",
                .formula = "exp(sin(2 pi x) + cos(2 pi y))",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::analytic,
                .bounds = with_rounding(std::exp(-2.), std::exp(2.)),
                .source = "ours",
                .derivation = "I_0(1)^2 and I_0(2)^2, as periodic-exp"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return exp(R(sin(R(2 * pi<R>() * p[0])) + cos(R(2 * pi<R>() * p[1]))));
    }
    template <class R>
    R integral() const {
        return squared(bessel_i0(R(1)));
    }
    template <class R>
    R second_moment() const {
        return squared(bessel_i0(R(2)));
    }
    template <class R>
    Panels<R> panels_x() const {
        return equal_panels<R>(2);
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return equal_panels<R>(2);
    }
};

}  // namespace plumb::formulas
