#pragma once

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

struct Exponential : Formula1D {
    Description about() const {
        return {.id = "exp",
                .formula = "e^x",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(1, std::numbers::e),
                .source = "ours",
                .derivation = "e - 1 and (e^2 - 1)/2"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return exp(x[0]);
    }
    template <class R>
    R integral() const {
        return exp(R(1)) - 1;
    }
    template <class R>
    R second_moment() const {
        return (exp(R(2)) - 1) / 2;
    }
};

struct ExponentialSum : Formula2D {
    Description about() const {
        return {.id = "exp-sum",
                .formula = "e^{x + y}",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(1, std::numbers::e * std::numbers::e),
                .source = "ours",
                .derivation = "(e - 1)^2 and ((e^2 - 1)/2)^2"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return exp(R(p[0] + p[1]));
    }
    template <class R>
    R integral() const {
        return squared(Exponential().integral<R>());
    }
    template <class R>
    R second_moment() const {
        return squared(Exponential().second_moment<R>());
    }
};

struct Gaussian2D : Formula2D {
    Description about() const {
        return {.id = "gaussian-2d",
                .formula = "exp(-x^2 - y^2)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(std::exp(-2.), 1),
                .source = "[Christensen et al. 2018], Gaussian function",
                .derivation = "(sqrt(pi)/2 erf 1)^2 and (sqrt(pi/8) erf sqrt 2)^2"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return exp(R(-squared(p[0]) - squared(p[1])));
    }
    template <class R>
    R integral() const {
        return pi<R>() / 4 * squared(R(Elementary<R>::erf(R(1))));
    }
    template <class R>
    R second_moment() const {
        return pi<R>() / 8 * squared(R(Elementary<R>::erf(sqrt(R(2)))));
    }
};

/// A peak that most samplers never see.
struct Spike : Formula1D {
    Description about() const {
        return {.id = "spike",
                .formula = "exp(-((x - 1/3) / 10^-4)^2)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::analytic,  // both ends are e^(−10^7)
                .bounds = with_rounding(0, 1),
                .source = "ours",
                .derivation = "w sqrt(pi)/2 (erf((1 - c)/w) + erf(c/w)); f^2 is the same with w/sqrt(2) for w"};
    }
    /// ∫ exp(−((x−c)/w)²).
    template <class R>
    static R mean_gaussian(const R& c, const R& w) {
        return w * sqrt(pi<R>()) / 2 * (Elementary<R>::erf(R((1 - c) / w)) + Elementary<R>::erf(R(c / w)));
    }
    /// Cut where a quadrature needs it: at the peak, on its flanks and where it is gone to 73 digits.
    template <class R>
    static Panels<R> around(const R& c, const R& w) {
        return cut_at<R>({R(c - 13 * w), R(c - 4 * w), c, R(c + 4 * w), R(c + 13 * w)});
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return exp(R(-squared(R((x[0] - R(1) / 3) * 10000))));
    }
    template <class R>
    R integral() const {
        return mean_gaussian(R(R(1) / 3), R(R(1) / 10000));
    }
    template <class R>
    R second_moment() const {
        return mean_gaussian(R(R(1) / 3), R(sqrt(R(1) / 2) / 10000));
    }
    template <class R>
    Panels<R> panels_x() const {
        return around(R(R(1) / 3), R(R(1) / 10000));
    }
};

struct Spike2D : Formula2D {
    Description about() const {
        return {.id = "spike-2d",
                .formula = "exp(-((x - 1/3)^2 + (y - 2/3)^2) / 10^-4)",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::analytic,  // every side is below e^(−1111)
                .bounds = with_rounding(0, 1),
                .source = "ours",
                .derivation = "the product of two spikes of width 1/100, as spike"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return exp(R(-10000 * (squared(R(p[0] - R(1) / 3)) + squared(R(p[1] - R(2) / 3)))));
    }
    template <class R>
    R integral() const {
        return squared(Spike::mean_gaussian(R(R(1) / 3), R(R(1) / 100)));  // 1/3 and 2/3 mirror each other
    }
    template <class R>
    R second_moment() const {
        return squared(Spike::mean_gaussian(R(R(1) / 3), R(sqrt(R(1) / 2) / 100)));
    }
    template <class R>
    Panels<R> panels_x() const {
        return Spike::around(R(R(1) / 3), R(R(1) / 100));
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return Spike::around(R(R(2) / 3), R(R(1) / 100));
    }
};

}  // namespace plumb::formulas
