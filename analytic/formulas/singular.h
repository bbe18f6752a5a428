#pragma once

#include <limits>

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// x^(−a/10): the mean 1/(1 − a/10) is finite for a < 10, the variance infinite for a ≥ 5.
struct InversePower : Formula1D {
    std::string id;
    int tenths;

    InversePower(std::string id, int tenths) : id(std::move(id)), tenths(tenths) {}

    Description about() const {
        return {.id = id,
                .formula = tenths == 5 ? "x^(-1/2)" : "x^(-9/10)",
                .smoothness = Smoothness::singular,
                .periodic_smoothness = Smoothness::singular,
                .bounds = {1, unbounded},
                .source = "ours",
                .derivation = "int x^p = 1/(p + 1); int x^{2p} diverges at 0 for 2p <= -1"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return tenths == 5 ? R(1 / sqrt(x[0])) : R(pow(x[0], R(-R(tenths) / 10)));
    }
    template <class R>
    R integral() const {
        return R(10) / (10 - tenths);
    }
    template <class R>
    R second_moment() const {
        return std::numeric_limits<R>::infinity();
    }
    template <class R>
    Panels<R> panels_x() const {
        return {{R(0), R(1), Singular::low, 1 - 0.1 * tenths}};
    }
};

struct Logarithm : Formula1D {
    Description about() const {
        return {.id = "log",
                .formula = "log x",
                .smoothness = Smoothness::singular,
                .periodic_smoothness = Smoothness::singular,
                .bounds = {-unbounded, 0},
                .source = "ours",
                .derivation = "-log x is exponentially distributed: mean 1, second moment 2"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return log(x[0]);
    }
    template <class R>
    R integral() const {
        return -1;
    }
    template <class R>
    R second_moment() const {
        return 2;
    }
    template <class R>
    Panels<R> panels_x() const {
        return {{R(0), R(1), Singular::low, 0.9}};
    }
};

struct LogarithmOfProduct : Formula2D {
    Description about() const {
        return {.id = "log-product",
                .formula = "log x + log y",
                .smoothness = Smoothness::singular,
                .periodic_smoothness = Smoothness::singular,
                .bounds = {-unbounded, 0},
                .source = "ours",
                .derivation = "minus a sum of two exponential variables: mean -2, variance 2, second moment 6"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return log(p[0]) + log(p[1]);
    }
    template <class R>
    R integral() const {
        return -2;
    }
    template <class R>
    R second_moment() const {
        return 6;
    }
    template <class R>
    Panels<R> panels_x() const {
        return {{R(0), R(1), Singular::low, 0.9}};
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return {{R(0), R(1), Singular::low, 0.9}};
    }
};

struct InverseDistance : Formula2D {
    Description about() const {
        return {.id = "inverse-distance",
                .formula = "1 / sqrt(x^2 + y^2)",
                .smoothness = Smoothness::singular,
                .periodic_smoothness = Smoothness::singular,
                .bounds = {0.7071, unbounded},
                .source = "ours",
                .derivation =
                    "twice the part below the diagonal in polar coordinates, 2 int_0^{pi/4} dphi / cos phi = "
                    "2 log(1 + sqrt 2); f^2 = r^-2 diverges with log r at the corner"};
    }
    template <class R>
    R value(const std::array<R, 2>& p) const {
        return 1 / sqrt(R(squared(p[0]) + squared(p[1])));
    }
    template <class R>
    R integral() const {
        return 2 * log(R(1 + sqrt(R(2))));
    }
    template <class R>
    R second_moment() const {
        return std::numeric_limits<R>::infinity();
    }
    template <class R>
    Panels<R> panels_x() const {
        return {{R(0), R(1), Singular::low, 0.9}};
    }
    template <class R>
    Panels<R> panels_y(const R& x) const {
        std::vector<R> cuts;  // the scale of 1/√(x² + y²) runs from x to 1
        for (R cut = x; cut < 1; cut *= 5) cuts.push_back(cut);
        return cut_at(cuts);
    }
};

}  // namespace plumb::formulas
