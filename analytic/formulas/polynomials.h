#pragma once

#include <fmt/format.h>

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

/// 1, x, x², x³, x⁵.
struct Monomial : Formula1D {
    std::string id;
    int power;

    Monomial(std::string id, int power) : id(std::move(id)), power(power) {}

    Description about() const {
        return {.id = id,
                .formula = power == 0   ? "1"
                           : power == 1 ? "x"
                                        : fmt::format("x^{}", power),
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = power == 0 ? Smoothness::analytic : Smoothness::jump,
                .bounds = {power == 0 ? 1. : 0., 1},
                .source = "ours",
                .derivation = "int x^n = 1/(n + 1), int x^{2n} = 1/(2n + 1)"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        R result = 1;
        for (int i = 0; i < power; ++i) result *= x[0];
        return result;
    }
    template <class R>
    R integral() const {
        return R(1) / (power + 1);
    }
    template <class R>
    R second_moment() const {
        return R(1) / (2 * power + 1);
    }
};

struct Parabola : Formula1D {
    Description about() const {
        return {.id = "parabola",
                .formula = "4 x (1 - x)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::kink,
                .bounds = {0, 1},
                .source = "ours",
                .derivation = "beta integrals: 4 B(2,2) = 2/3 and 16 B(3,3) = 8/15"};
    }
    template <class R>
    R value(const std::array<R, 1>& p) const {
        const auto& [x] = p;
        return 4 * x * (1 - x);
    }
    template <class R>
    R integral() const {
        return R(2) / 3;
    }
    template <class R>
    R second_moment() const {
        return R(8) / 15;
    }
};

/// A zero integral made of large values: delta must be relative to √E f².
struct Cancellation : Formula1D {
    Description about() const {
        return {.id = "cancellation",
                .formula = "10^6 (5 x^4 - 1)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {-1e6, 4e6},
                .source = "ours",
                .derivation = "5/5 - 1 = 0; 25/9 - 10/5 + 1 = 16/9"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return 1000000 * (5 * squared(squared(x[0])) - 1);
    }
    template <class R>
    R integral() const {
        return 0;
    }
    template <class R>
    R second_moment() const {
        return R(16000000000000) / 9;
    }
};

/// The bilinear function of [Christensen et al. 2018].
struct Product : Formula2D {
    Description about() const {
        return {.id = "product",
                .formula = "x y",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {0, 1},
                .source = "[Christensen et al. 2018], bilinear function",
                .derivation = "(1/2)^2 and (1/3)^2"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return p[0] * p[1];
    }
    template <class R>
    R integral() const {
        return R(1) / 4;
    }
    template <class R>
    R second_moment() const {
        return R(1) / 9;
    }
};

struct Constant2D : Formula2D {
    Description about() const {
        return {.id = "constant-2d",
                .formula = "1",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::analytic,
                .bounds = {1, 1},
                .source = "ours",
                .derivation = "1 and 1"};
    }
    template <class R>
    R value(const std::array<R, 2>&) const {
        return 1;
    }
    template <class R>
    R integral() const {
        return 1;
    }
    template <class R>
    R second_moment() const {
        return 1;
    }
};

struct Polynomial2D : Formula2D {
    Description about() const {
        return {.id = "polynomial-2d",
                .formula = "x^2 y",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {0, 1},
                .source = "ours",
                .derivation = "1/3 1/2 and 1/5 1/3"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return p[0] * p[0] * p[1];
    }
    template <class R>
    R integral() const {
        return R(1) / 6;
    }
    template <class R>
    R second_moment() const {
        return R(1) / 15;
    }
};

struct Parabola2D : Formula2D {
    Description about() const {
        return {.id = "parabola-2d",
                .formula = "16 x (1 - x) y (1 - y)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::kink,
                .bounds = {0, 1},
                .source = "ours",
                .derivation = "(2/3)^2 and (8/15)^2, as parabola"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        const auto& [x, y] = p;
        return 16 * x * (1 - x) * y * (1 - y);
    }
    template <class R>
    R integral() const {
        return R(4) / 9;
    }
    template <class R>
    R second_moment() const {
        return R(64) / 225;
    }
};

struct Cancellation2D : Formula2D {
    Description about() const {
        return {.id = "cancellation-2d",
                .formula = "10^6 (9 x^2 y^2 - 1)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {-1e6, 8e6},
                .source = "ours",
                .derivation = "9/9 - 1 = 0; 81/25 - 18/9 + 1 = 56/25"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return 1000000 * (9 * squared(R(p[0] * p[1])) - 1);
    }
    template <class R>
    R integral() const {
        return 0;
    }
    template <class R>
    R second_moment() const {
        return R(2240000000000);
    }
};

}  // namespace plumb::formulas
