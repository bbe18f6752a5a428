#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <type_traits>

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

/// What an instance of one of the six families of [Genz 1984] is drawn from: difficulties a and shifts u, drawn once.
/// The 1D difficulties are uniform in [h/2, 3h/2], the 2D ones a random split of h, with the usual h = 9, 7.25, 1.85,
/// 7.03, 20.4, 4.3 of the families. All are multiples of 1/64, so that every number type holds the same ones.
template <int D>
struct GenzParameters {
    int instance;
    std::array<double, D> a, u;

    [[nodiscard]] Description describe(std::string_view family, std::string_view formula, Smoothness smoothness,
                                       Interval bounds, std::string derivation) const {
        return {.id = fmt::format("genz/{}{}-{}", family, D == 1 ? "" : "-2d", instance),
                .formula = fmt::format("{}, a = {}, u = {}", formula, fmt::join(a, " "), fmt::join(u, " ")),
                .smoothness = smoothness,
                .periodic_smoothness = Smoothness::jump,
                .bounds = bounds,
                .source = "[Genz 1984], Testing multidimensional integration routines",
                .derivation = std::move(derivation)};
    }
    /// The product over the axes of factor(a_i, u_i).
    template <class R, class Factor>
    R product(const Factor& factor) const {
        R result = 1;
        for (std::size_t i = 0; i < D; ++i) result *= factor(R(a[i]), R(u[i]));
        return result;
    }
    /// The sum over the axes of term(a_i, u_i, x_i).
    template <class R, class Term>
    R sum(const std::array<R, D>& x, const Term& term) const {
        R result = 0;
        for (std::size_t i = 0; i < D; ++i) result += term(R(a[i]), R(u[i]), x[i]);
        return result;
    }
    template <class R>
    R a_dot(const std::array<R, D>& x) const {
        return sum(x, [](const R& a_i, const R&, const R& x_i) { return R(a_i * x_i); });
    }
};

template <int D>
using GenzBase = std::conditional_t<D == 1, Formula1D, Formula2D>;

template <int D>
struct GenzOscillatory : GenzBase<D> {
    GenzParameters<D> p;

    Description about() const {
        return p.describe("oscillatory", "cos(2 pi u_1 + sum a_i x_i)", Smoothness::analytic, with_rounding(-1, 1),
                          "Re e^{2 pi i u_1} prod (e^{i a_j} - 1)/(i a_j); f^2 = (1 + cos(2 phase))/2");
    }
    template <class R>
    R value(const std::array<R, D>& x) const {
        return cos(R(2 * pi<R>() * p.u[0] + p.a_dot(x)));
    }
    /// ∫ cos(k · phase) = cos(k · phase in the middle of the cube) ∏ sin(k a/2) / (k a/2).
    template <class R>
    R mean_cosine(int k) const {
        std::array<R, D> middle;
        middle.fill(R(1) / 2);
        return cos(R(k * (2 * pi<R>() * p.u[0] + p.a_dot(middle)))) *
               p.template product<R>([k](const R& a, const R&) { return R(sin(R(k * a / 2)) / (k * a / 2)); });
    }
    template <class R>
    R integral() const {
        return mean_cosine<R>(1);
    }
    template <class R>
    R second_moment() const {
        return (1 + mean_cosine<R>(2)) / 2;
    }
};

template <int D>
struct GenzProductPeak : GenzBase<D> {
    GenzParameters<D> p;

    Description about() const {
        const double peak = p.template product<double>([](double a, double) { return a * a; });
        return p.describe("product-peak", "prod 1 / (a_i^-2 + (x_i - u_i)^2)", Smoothness::analytic,
                          with_rounding(0, peak),
                          "with z = a (x - u): a int dz/(1 + z^2) = a atan z, and for f^2 a^3 int dz/(1 + z^2)^2 = "
                          "a^3 (atan z + z/(1 + z^2))/2, from z = -a u to a (1 - u)");
    }
    template <class R>
    R value(const std::array<R, D>& x) const {
        R denominator = 1;
        for (std::size_t i = 0; i < D; ++i) denominator *= 1 / squared(R(p.a[i])) + squared(R(x[i] - p.u[i]));
        return 1 / denominator;
    }
    template <class R>
    R integral() const {
        return p.template product<R>(
            [](const R& a, const R& u) { return R(a * (atan(R(a * (1 - u))) + atan(R(a * u)))); });
    }
    template <class R>
    R second_moment() const {
        const auto half = [](const R& z) { return R((atan(z) + z / (1 + z * z)) / 2); };
        return p.template product<R>(
            [&](const R& a, const R& u) { return R(a * a * a * (half(R(a * (1 - u))) + half(R(a * u)))); });
    }
    /// Cut where the distance from the peak is 0, 1, 3 and 9 of its widths 1/a.
    template <class R>
    static Panels<R> around_peak(const R& a, const R& u) {
        std::vector<R> cuts{u};
        for (const int widths : {1, 3, 9}) cuts.insert(cuts.end(), {R(u - widths / a), R(u + widths / a)});
        return cut_at(cuts);
    }
    template <class R>
    Panels<R> panels_x() const {
        return around_peak(R(p.a[0]), R(p.u[0]));
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return around_peak(R(p.a[D - 1]), R(p.u[D - 1]));
    }
};

template <int D>
struct GenzCornerPeak : GenzBase<D> {
    GenzParameters<D> p;

    Description about() const {
        return p.describe("corner-peak", D == 1 ? "(1 + a x)^-2" : "(1 + a_1 x + a_2 y)^-3", Smoothness::analytic,
                          with_rounding(0, 1),
                          "an antiderivative along every axis, its values at the corners with alternating signs");
    }
    template <class R>
    R value(const std::array<R, D>& x) const {
        const R base = 1 + p.a_dot(x);
        return 1 / (D == 1 ? R(base * base) : R(base * base * base));
    }
    /// ∫ (1 + a·x)^−power.
    template <class R>
    R mean_power(int power) const {
        const auto falling = [](const R& base, int exponent) { return R(1 / pow(base, exponent)); };
        const R a = p.a[0], b = p.a[D - 1];
        if (D == 1) return (1 - falling(1 + a, power - 1)) / ((power - 1) * a);
        const int q = power - 2;
        return (1 - falling(1 + a, q) - falling(1 + b, q) + falling(1 + a + b, q)) / ((power - 1) * q * a * b);
    }
    template <class R>
    R integral() const {
        return mean_power<R>(D + 1);
    }
    template <class R>
    R second_moment() const {
        return mean_power<R>(2 * (D + 1));
    }
};

template <int D>
struct GenzGaussian : GenzBase<D> {
    GenzParameters<D> p;

    Description about() const {
        return p.describe("gaussian", "exp(-sum a_i^2 (x_i - u_i)^2)", Smoothness::analytic, with_rounding(0, 1),
                          "prod sqrt(pi)/(2 a) (erf(a (1 - u)) + erf(a u)); f^2 is the same with a sqrt(2) for a");
    }
    template <class R>
    R value(const std::array<R, D>& x) const {
        return exp(R(-p.sum(x, [](const R& a, const R& u, const R& x_i) { return squared(R(a * (x_i - u))); })));
    }
    /// ∫ exp(−scale² Σ a² (x−u)²).
    template <class R>
    R mean_gaussian(const R& scale) const {
        return p.template product<R>([&](const R& a, const R& u) {
            const R s = scale * a;
            const R both_sides = Elementary<R>::erf(s * (1 - u)) + Elementary<R>::erf(s * u);
            return R(sqrt(pi<R>()) / (2 * s) * both_sides);
        });
    }
    template <class R>
    R integral() const {
        return mean_gaussian(R(1));
    }
    template <class R>
    R second_moment() const {
        return mean_gaussian(R(sqrt(R(2))));
    }
    template <class R>
    Panels<R> panels_x() const {
        return cut_at<R>({R(p.u[0])});
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return cut_at<R>({R(p.u[D - 1])});
    }
};

template <int D>
struct GenzC0 : GenzBase<D> {
    GenzParameters<D> p;

    Description about() const {
        return p.describe("c0", "exp(-sum a_i |x_i - u_i|)", Smoothness::kink, with_rounding(0, 1),
                          "prod (2 - e^{-a u} - e^{-a (1 - u)})/a; f^2 is the same with 2a for a");
    }
    template <class R>
    R value(const std::array<R, D>& x) const {
        return exp(R(-p.sum(x, [](const R& a, const R& u, const R& x_i) { return R(a * abs(R(x_i - u))); })));
    }
    /// ∫ exp(−k Σ a |x−u|).
    template <class R>
    R mean_exponential(int k) const {
        return p.template product<R>(
            [k](const R& a, const R& u) { return R((2 - exp(R(-k * a * u)) - exp(R(-k * a * (1 - u)))) / (k * a)); });
    }
    template <class R>
    R integral() const {
        return mean_exponential<R>(1);
    }
    template <class R>
    R second_moment() const {
        return mean_exponential<R>(2);
    }
    template <class R>
    Panels<R> panels_x() const {
        return cut_at<R>({R(p.u[0])});
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return cut_at<R>({R(p.u[D - 1])});
    }
};

template <int D>
struct GenzDiscontinuous : GenzBase<D> {
    GenzParameters<D> p;

    Description about() const {
        return p.describe("discontinuous", "exp(sum a_i x_i) where every x_i <= u_i, else 0", Smoothness::jump,
                          with_rounding(0, std::exp(p.a_dot(p.u))),
                          "prod (e^{a u} - 1)/a; f^2 is the same with 2a for a");
    }
    template <class R>
    R value(const std::array<R, D>& x) const {
        for (std::size_t i = 0; i < D; ++i)
            if (x[i] > p.u[i]) return 0;
        return exp(p.a_dot(x));
    }
    /// ∫ exp(k a·x) over the box below u.
    template <class R>
    R mean_exponential(int k) const {
        return p.template product<R>([k](const R& a, const R& u) { return R((exp(R(k * a * u)) - 1) / (k * a)); });
    }
    template <class R>
    R integral() const {
        return mean_exponential<R>(1);
    }
    template <class R>
    R second_moment() const {
        return mean_exponential<R>(2);
    }
    template <class R>
    Panels<R> panels_x() const {
        return cut_at<R>({R(p.u[0])});
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return cut_at<R>({R(p.u[D - 1])});
    }
};

/// The instances, in the order of the families.
inline void visit_genz_1d(const auto& visit) {
    visit(GenzOscillatory<1>{{}, {1, {11}, {0.453125}}});
    visit(GenzOscillatory<1>{{}, {2, {13.078125}, {0.28125}}});
    visit(GenzProductPeak<1>{{}, {1, {6.515625}, {0.703125}}});
    visit(GenzProductPeak<1>{{}, {2, {5.609375}, {0.90625}}});
    visit(GenzCornerPeak<1>{{}, {1, {1.984375}, {0.109375}}});
    visit(GenzCornerPeak<1>{{}, {2, {0.9375}, {0.9375}}});
    visit(GenzGaussian<1>{{}, {1, {7.296875}, {0.859375}}});
    visit(GenzGaussian<1>{{}, {2, {8.484375}, {0.421875}}});
    visit(GenzC0<1>{{}, {1, {29.015625}, {0.59375}}});
    visit(GenzC0<1>{{}, {2, {22.921875}, {0.875}}});
    visit(GenzDiscontinuous<1>{{}, {1, {5.390625}, {0.734375}}});
    visit(GenzDiscontinuous<1>{{}, {2, {4.859375}, {0.40625}}});
}
inline void visit_genz_2d(const auto& visit) {
    visit(GenzOscillatory<2>{{}, {1, {5.890625, 3.109375}, {0.703125, 0.25}}});
    visit(GenzOscillatory<2>{{}, {2, {6.890625, 2.109375}, {0.8125, 0.4375}}});
    visit(GenzProductPeak<2>{{}, {1, {3.65625, 3.59375}, {0.703125, 0.546875}}});
    visit(GenzProductPeak<2>{{}, {2, {4.671875, 2.578125}, {0.25, 0.140625}}});
    visit(GenzCornerPeak<2>{{}, {1, {0.6875, 1.171875}, {0.703125, 0.28125}}});
    visit(GenzCornerPeak<2>{{}, {2, {1.046875, 0.8125}, {0.9375, 0.78125}}});
    visit(GenzGaussian<2>{{}, {1, {2.234375, 4.796875}, {0.796875, 0.671875}}});
    visit(GenzGaussian<2>{{}, {2, {1.984375, 5.046875}, {0.53125, 0.203125}}});
    visit(GenzC0<2>{{}, {1, {11.828125, 8.578125}, {0.28125, 0.78125}}});
    visit(GenzC0<2>{{}, {2, {16.28125, 4.109375}, {0.78125, 0.46875}}});
    visit(GenzDiscontinuous<2>{{}, {1, {3.0, 1.3125}, {0.3125, 0.46875}}});
    visit(GenzDiscontinuous<2>{{}, {2, {1.25, 3.0625}, {0.9375, 0.8125}}});
}

}  // namespace plumb::formulas
