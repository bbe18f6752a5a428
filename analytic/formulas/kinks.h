#pragma once

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

struct Kink : Formula1D {
    Description about() const {
        return {.id = "kink",
                .formula = "|x - 3/10|",
                .smoothness = Smoothness::kink,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(0, 0.7),
                .source = "ours",
                .derivation = "two triangles: (0.3^2 + 0.7^2)/2; and (0.3^3 + 0.7^3)/3"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return abs(R(x[0] - R(3) / 10));
    }
    template <class R>
    R integral() const {
        return R(29) / 100;
    }
    template <class R>
    R second_moment() const {
        return R(37) / 300;
    }
    template <class R>
    Panels<R> panels_x() const {
        return cut_at<R>({R(R(3) / 10)});
    }
};

struct Kink2D : Formula2D {
    Description about() const {
        return {.id = "kink-2d",
                .formula = "|2 x + y - 13/10|",
                .smoothness = Smoothness::kink,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(0, 1.7),
                .source = "ours",
                .derivation =
                    "F(s) = |s|^3/6 has F'' = |s|: (F(1.7) - F(0.7) - F(-0.3) + F(-1.3))/2; f^2 is the variance "
                    "4/12 + 1/12 and the squared mean 0.2^2 of 2x + y - 1.3"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return abs(R(2 * p[0] + p[1] - R(13) / 10));
    }
    template <class R>
    R integral() const {
        return R(4913 - 343 - 27 + 2197) / 12000;  // in thousandths: 1.7^3 = 4.913 and so on
    }
    template <class R>
    R second_moment() const {
        return R(5) / 12 + R(1) / 25;
    }
    template <class R>
    Panels<R> panels_x() const {
        return cut_at<R>({R(R(3) / 20), R(R(13) / 20)});  // where the crease enters and leaves
    }
    template <class R>
    Panels<R> panels_y(const R& x) const {
        return cut_at<R>({R(R(13) / 10 - 2 * x)});
    }
};

}  // namespace plumb::formulas
