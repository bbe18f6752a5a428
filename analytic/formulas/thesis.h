#pragma once

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

/// The 1D function of [thesis, section 4.5.1]: two quarter circles of radius 1/4, a trapezoid, three humps.
/// The radicands are factored: printed as −x² + x/2 and −x² + x − 0.1875, here manifestly not negative.
struct Thesis : Formula1D {
    Description about() const {
        return {.id = "thesis-1d",
                .formula =
                    "10 times, up to x = 1/4, 1/2, 11/20, 13/20, 7/10, 4/5, 9/10, 1: sqrt(x (1/2 - x)); "
                    "1/4 - sqrt((x - 1/4)(3/4 - x)); 20 (x - 1/2); 1; 20 (7/10 - x); "
                    "sin(10 pi (x - 7/10))/10; sin(10 pi (x - 8/10))/4; sin(10 pi (x - 9/10))/2",
                .smoothness = Smoothness::root,
                .periodic_smoothness = Smoothness::root,
                .bounds = with_rounding(0, 10),
                .source = "[thesis, section 4.5.1]",
                .derivation =
                    "the quarter circles complement each other to the square 1/16, the trapezoid is 3/20, the "
                    "humps (1/10 + 1/4 + 1/2)/(5 pi): ten times is 17/8 + 17/(10 pi). Of f^2/100: the arcs 1/96 "
                    "and r^3 (5/3 - pi/2), r = 1/4, the trapezoid 1/10 + 1/30, the humps "
                    "(1/100 + 1/16 + 1/4)/20"};
    }
    template <class R>
    R value(const std::array<R, 1>& p) const {
        const auto& [x] = p;
        const auto hump = [&](int tenths) { return R(sin(R(10 * pi<R>() * (x - R(tenths) / 10)))); };
        if (4 * x <= 1) return 10 * sqrt(R(x * (R(1) / 2 - x)));
        if (2 * x <= 1) return 10 * (R(1) / 4 - sqrt(R((x - R(1) / 4) * (R(3) / 4 - x))));
        if (x <= R(11) / 20) return 200 * (x - R(1) / 2);
        if (x <= R(13) / 20) return 10;
        if (x <= R(7) / 10) return 200 * (R(7) / 10 - x);
        if (x <= R(4) / 5) return hump(7);
        if (x <= R(9) / 10) return R(5) / 2 * hump(8);
        return 5 * hump(9);
    }
    template <class R>
    R integral() const {
        return R(17) / 8 + 17 / (10 * pi<R>());
    }
    template <class R>
    R second_moment() const {
        const R arcs = R(1) / 96 + (R(5) / 3 - pi<R>() / 2) / 64;
        const R trapezoid = R(1) / 10 + R(1) / 30;
        const R humps = (R(1) / 100 + R(1) / 16 + R(1) / 4) / 20;
        return 100 * (arcs + trapezoid + humps);
    }
    template <class R>
    Panels<R> panels_x() const {
        Panels<R> panels{{R(0), R(R(1) / 4), Singular::low}, {R(R(1) / 4), R(R(1) / 2), Singular::low}};
        for (int twentieths = 10; twentieths < 20; ++twentieths)
            panels.push_back({R(R(twentieths) / 20), R(R(twentieths + 1) / 20)});
        return panels;
    }
};

}  // namespace plumb::formulas
