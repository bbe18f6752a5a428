#pragma once

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

// Indicator functions: the integral is an area A, the variance A (1 − A).

struct Step : Formula1D {
    Description about() const {
        return {.id = "step",
                .formula = "1 where x < 1/pi, else 0",
                .smoothness = Smoothness::jump,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {0, 1},
                .source = "ours, after the 2D step of [Christensen et al. 2018]",
                .derivation = "the length 1/pi; f^2 = f"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return x[0] * pi<R>() < 1 ? 1 : 0;
    }
    template <class R>
    R integral() const {
        return 1 / pi<R>();
    }
    template <class R>
    R second_moment() const {
        return integral<R>();
    }
    template <class R>
    Panels<R> panels_x() const {
        return cut_at<R>({R(1 / pi<R>())});
    }
};

struct Step2D : Formula2D {
    Description about() const {
        return {.id = "step-2d",
                .formula = "1 where x < 1/pi, else 0",
                .smoothness = Smoothness::jump,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {0, 1},
                .source = "[Christensen et al. 2018], step function",
                .derivation = "the area 1/pi; f^2 = f"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return p[0] * pi<R>() < 1 ? 1 : 0;
    }
    template <class R>
    R integral() const {
        return 1 / pi<R>();
    }
    template <class R>
    R second_moment() const {
        return integral<R>();
    }
    template <class R>
    Panels<R> panels_x() const {
        return cut_at<R>({R(1 / pi<R>())});
    }
};

struct QuarterDisk : Formula2D {
    Description about() const {
        return {.id = "quarter-disk",
                .formula = "1 where x^2 + y^2 < 2/pi, else 0",
                .smoothness = Smoothness::jump,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {0, 1},
                .source = "[Christensen et al. 2018], disk function",
                .derivation = "a quarter of pi r^2 with r^2 = 2/pi < 1: 1/2; f^2 = f"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return squared(p[0]) + squared(p[1]) < 2 / pi<R>() ? 1 : 0;
    }
    template <class R>
    R integral() const {
        return R(1) / 2;
    }
    template <class R>
    R second_moment() const {
        return R(1) / 2;
    }
    template <class R>
    Panels<R> panels_x() const {
        const R radius = sqrt(R(2 / pi<R>()));
        return {{R(0), radius, Singular::high}, {radius, R(1)}};
    }
    template <class R>
    Panels<R> panels_y(const R& x) const {
        const R square = 2 / pi<R>() - squared(x);
        return cut_at<R>({square > 0 ? R(sqrt(square)) : R(0)});
    }
};

struct Triangle : Formula2D {
    Description about() const {
        return {.id = "triangle",
                .formula = "1 where y > x, else 0",
                .smoothness = Smoothness::jump,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {0, 1},
                .source = "[Christensen et al. 2018], triangle function",
                .derivation = "half the square; f^2 = f"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return p[1] > p[0] ? 1 : 0;
    }
    template <class R>
    R integral() const {
        return R(1) / 2;
    }
    template <class R>
    R second_moment() const {
        return R(1) / 2;
    }
    template <class R>
    Panels<R> panels_y(const R& x) const {
        return cut_at<R>({x});
    }
};

struct Edge : Formula2D {
    Description about() const {
        return {.id = "edge",
                .formula = "1 where y < 1/5 + 11/20 x, else 0",
                .smoothness = Smoothness::jump,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {0, 1},
                .source = "ours",
                .derivation = "a trapezoid of the heights 1/5 and 3/4: 19/40; f^2 = f"};
    }
    template <class R>
    static R height(const R& x) {
        return R(1) / 5 + R(11) / 20 * x;
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return p[1] < height(p[0]) ? 1 : 0;
    }
    template <class R>
    R integral() const {
        return R(19) / 40;
    }
    template <class R>
    R second_moment() const {
        return integral<R>();
    }
    template <class R>
    Panels<R> panels_y(const R& x) const {
        return cut_at<R>({height(x)});
    }
};

/// Half the chord of the disk of radius r at the distance d from its centre; 0 outside.
template <class R>
R half_chord(const R& r, const R& d) {
    const R square = (r - d) * (r + d);
    return square > 0 ? R(sqrt(square)) : R(0);
}

struct Disk : Formula2D {
    Description about() const {
        return {.id = "disk",
                .formula = "1 where (x - 9/20)^2 + (y - 11/20)^2 < (3/10)^2, else 0",
                .smoothness = Smoothness::jump,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {0, 1},
                .source = "ours",
                .derivation = "pi r^2, the disk lies inside the square; f^2 = f"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return squared(R(p[0] - R(9) / 20)) + squared(R(p[1] - R(11) / 20)) < R(9) / 100 ? 1 : 0;
    }
    template <class R>
    R integral() const {
        return pi<R>() * 9 / 100;
    }
    template <class R>
    R second_moment() const {
        return integral<R>();
    }
    template <class R>
    Panels<R> panels_x() const {
        const R left = R(3) / 20, centre = R(9) / 20, right = R(3) / 4;
        return {{R(0), left}, {left, centre, Singular::low}, {centre, right, Singular::high}, {right, R(1)}};
    }
    template <class R>
    Panels<R> panels_y(const R& x) const {
        const R half = half_chord(R(R(3) / 10), R(x - R(9) / 20));
        return cut_at<R>({R(R(11) / 20 - half), R(R(11) / 20 + half)});
    }
};

/// Public suites give such a disk the area of the whole one.
struct CutDisk : Formula2D {
    Description about() const {
        return {.id = "disk-cut",
                .formula = "1 where (x - 7/10)^2 + (y - 1/2)^2 < (2/5)^2, else 0",
                .smoothness = Smoothness::jump,
                .periodic_smoothness = Smoothness::jump,
                .bounds = {0, 1},
                .source = "ours",
                .derivation =
                    "the disk leaves the square at x = 1, at the distance h = 3/10 from its centre: pi r^2 less "
                    "the segment r^2 arccos(h/r) - h sqrt(r^2 - h^2); f^2 = f"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return squared(R(p[0] - R(7) / 10)) + squared(R(p[1] - R(1) / 2)) < R(4) / 25 ? 1 : 0;
    }
    template <class R>
    R integral() const {
        const R r = R(2) / 5, h = R(3) / 10;
        return pi<R>() * r * r - (r * r * acos(R(h / r)) - h * half_chord(r, h));
    }
    template <class R>
    R second_moment() const {
        return integral<R>();
    }
    template <class R>
    Panels<R> panels_x() const {
        const R left = R(3) / 10, centre = R(7) / 10;
        return {{R(0), left}, {left, centre, Singular::low}, {centre, R(1)}};
    }
    template <class R>
    Panels<R> panels_y(const R& x) const {
        const R half = half_chord(R(R(2) / 5), R(x - R(7) / 10));
        return cut_at<R>({R(R(1) / 2 - half), R(R(1) / 2 + half)});
    }
};

}  // namespace plumb::formulas
