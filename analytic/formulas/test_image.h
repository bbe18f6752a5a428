#pragma once

#include "analytic/formulas/edges.h"
#include "analytic/formulas/formula.h"

namespace plumb::formulas {

/// A procedural image with what images have: a curved edge (a sun in a smooth sky), texture (lower left), and a
/// straight edge at an angle between a dark and a shaded area (lower right).
struct TestImage : Formula2D {
    Description about() const {
        return {.id = "test-image",
                .formula =
                    "y >= 1/2: 1 where (x - 7/10)^2 + (y - 3/4)^2 < (3/20)^2, else 1/4 + y/2; "
                    "y < 1/2, x < 1/2: 1/2 + 2/5 sin(70 x) cos(50 y); "
                    "y < 1/2, x >= 1/2: 1/20 where y < 1/10 + 3/5 (x - 1/2), else x (1 - y)",
                .smoothness = Smoothness::jump,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(0.05, 1),
                .source = "ours",
                .derivation =
                    "region by region: the sky 5/16 and 19/96, the sun's disk A = pi r^2 with the sky's mean "
                    "5/8 and mean square 25/64 + r^2/16 in it; products of sines and cosines; polynomials"};
    }
    template <class R>
    static R sun_half(const R& x) {
        return half_chord(R(R(3) / 20), R(x - R(7) / 10));
    }
    template <class R>
    static R slope(const R& x) {
        return R(1) / 10 + R(3) / 5 * (x - R(1) / 2);
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        const auto& [x, y] = p;
        if (2 * y >= 1) {
            const bool sun = squared(R(x - R(7) / 10)) + squared(R(y - R(3) / 4)) < R(9) / 400;
            return sun ? R(1) : R(R(1) / 4 + y / 2);
        }
        if (2 * x < 1) return R(1) / 2 + R(2) / 5 * sin(R(70 * x)) * cos(R(50 * y));
        return y < slope(x) ? R(R(1) / 20) : R(x * (1 - y));
    }
    template <class R>
    R integral() const {
        const R sun = pi<R>() * 9 / 400;
        const R sky = R(5) / 16 + sun * (1 - R(5) / 8);
        const R texture = R(1) / 8 + R(2) / 5 * (1 - cos(R(35))) / 70 * sin(R(25)) / 50;
        const R dark = R(1) / 8 / 20, shaded = R(177) / 3200;
        return sky + texture + dark + shaded;
    }
    template <class R>
    R second_moment() const {
        const R r2 = R(9) / 400, sun = pi<R>() * r2;
        const R sky = R(19) / 96 + sun * (1 - (R(25) / 64 + r2 / 16));
        const R sine = (1 - cos(R(35))) / 70, sine2 = R(1) / 4 - sin(R(70)) / 280;
        const R cosine = sin(R(25)) / 50, cosine2 = R(1) / 4 + sin(R(50)) / 200;
        const R texture = R(1) / 16 + R(2) / 5 * sine * cosine + R(4) / 25 * sine2 * cosine2;
        const R dark = R(1) / 8 / 400, shaded = R(18169) / 720000;
        return sky + texture + dark + shaded;
    }
    template <class R>
    Panels<R> panels_x() const {
        const auto at = [](int percent) { return R(R(percent) / 100); };
        return {{at(0), at(17)},
                {at(17), at(34)},
                {at(34), at(50)},
                {at(50), at(55)},
                {at(55), at(70), Singular::low},
                {at(70), at(85), Singular::high},
                {at(85), at(100)}};
    }
    template <class R>
    Panels<R> panels_y(const R& x) const {
        std::vector<R> cuts{R(R(1) / 2)};
        if (2 * x < 1)
            cuts.insert(cuts.end(), {R(R(1) / 6), R(R(1) / 3)});  // whole waves of the texture
        else
            cuts.push_back(slope(x));
        if (const R half = sun_half(x); half > 0) cuts.insert(cuts.end(), {R(R(3) / 4 - half), R(R(3) / 4 + half)});
        return cut_at(cuts);
    }
};

}  // namespace plumb::formulas
