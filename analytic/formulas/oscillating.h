#pragma once

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

struct Sine : Formula1D {
    Description about() const {
        return {.id = "sine",
                .formula = "sin(2 pi x)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::analytic,
                .bounds = with_rounding(-1, 1),
                .source = "ours",
                .derivation = "whole periods: 0 and 1/2"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return sin(R(2 * pi<R>() * x[0]));
    }
    template <class R>
    R integral() const {
        return 0;
    }
    template <class R>
    R second_moment() const {
        return R(1) / 2;
    }
};

struct Oscillating : Formula1D {
    Description about() const {
        return {.id = "oscillating",
                .formula = "cos(50 x)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(-1, 1),
                .source = "ours",
                .derivation = "sin(50)/50; f^2 = (1 + cos(100 x))/2 gives 1/2 + sin(100)/200"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return cos(R(50 * x[0]));
    }
    template <class R>
    R integral() const {
        return sin(R(50)) / 50;
    }
    template <class R>
    R second_moment() const {
        return R(1) / 2 + sin(R(100)) / 200;
    }
    template <class R>
    Panels<R> panels_x() const {
        return equal_panels<R>(4);
    }
};

/// Every regular grid of 64 points, or of a divisor of 64, sees the constant 2.
struct Aliasing : Formula1D {
    Description about() const {
        return {.id = "aliasing",
                .formula = "1 + cos(2 pi 64 x)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::analytic,
                .bounds = with_rounding(0, 2),
                .source = "ours",
                .derivation = "whole periods: 1 and 1 + 1/2"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return 1 + cos(R(128 * pi<R>() * x[0]));
    }
    template <class R>
    R integral() const {
        return 1;
    }
    template <class R>
    R second_moment() const {
        return R(3) / 2;
    }
    template <class R>
    Panels<R> panels_x() const {
        return equal_panels<R>(16);
    }
};

struct Oscillating2D : Formula2D {
    Description about() const {
        return {.id = "oscillating-2d",
                .formula = "sin(20 x) cos(15 y)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(-1, 1),
                .source = "ours",
                .derivation = "(1 - cos 20)/20 sin(15)/15; (1/2 - sin(40)/80) (1/2 + sin(30)/60)"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return sin(R(20 * p[0])) * cos(R(15 * p[1]));
    }
    template <class R>
    R integral() const {
        return (1 - cos(R(20))) / 20 * sin(R(15)) / 15;
    }
    template <class R>
    R second_moment() const {
        return (R(1) / 2 - sin(R(40)) / 80) * (R(1) / 2 + sin(R(30)) / 60);
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

/// Every regular grid of 16 × 16 points sees the constant 2.
struct Aliasing2D : Formula2D {
    Description about() const {
        return {.id = "aliasing-2d",
                .formula = "1 + cos(2 pi 16 x) cos(2 pi 16 y)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::analytic,
                .bounds = with_rounding(0, 2),
                .source = "ours",
                .derivation = "whole periods: 1 and 1 + 1/4"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return 1 + cos(R(32 * pi<R>() * p[0])) * cos(R(32 * pi<R>() * p[1]));
    }
    template <class R>
    R integral() const {
        return 1;
    }
    template <class R>
    R second_moment() const {
        return R(5) / 4;
    }
    template <class R>
    Panels<R> panels_x() const {
        return equal_panels<R>(8);
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return equal_panels<R>(8);
    }
};

}  // namespace plumb::formulas
