#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "analytic/formulas/elementary.h"
#include "analytic/integrand.h"

namespace plumb::formulas {

/// What a person reads about a formula; see Integrand.
struct Description {
    std::string id, formula;
    Smoothness smoothness, periodic_smoothness;
    Interval bounds{};
    std::string source, derivation;
};

/// Bounds that rounding in double may overstep by some ulp.
inline Interval with_rounding(double low, double high) {
    const double slack = 1e-12 * std::max(std::abs(low), std::abs(high));
    return {low - slack, high + slack};
}

/// Towards which end a panel's integrand has a singularity (of it or of a derivative).
enum class Singular { nowhere, low, high };

/// An interval inside which a formula is analytic: what a quadrature may treat as one piece.
template <class R>
struct Panel {
    R from, to;
    Singular singular = Singular::nowhere;
    double mass_exponent = 1;  ///< the integral over the part within t of the singular end falls as t^mass_exponent
};
template <class R>
using Panels = std::vector<Panel<R>>;

/// [0,1] cut at the given places; those outside cut nothing.
template <class R>
Panels<R> cut_at(std::vector<R> cuts) {
    cuts.insert(cuts.end(), {R(0), R(1)});
    for (R& cut : cuts) cut = std::clamp(cut, R(0), R(1));
    std::ranges::sort(cuts);
    Panels<R> panels;
    for (std::size_t i = 1; i < cuts.size(); ++i)
        if (cuts[i - 1] < cuts[i]) panels.push_back({cuts[i - 1], cuts[i]});
    return panels;
}

/// [0,1] in n equal panels, for what oscillates.
template <class R>
Panels<R> equal_panels(int n) {
    Panels<R> panels;
    for (int i = 0; i < n; ++i) panels.push_back({R(i) / n, R(i + 1) / n});
    return panels;
}

// A formula is a struct with
//   Description about() const;
//   template <class R> R value(const std::array<R, D>&) const;
//   template <class R> R integral() const, second_moment() const;     the closed forms of ∫ f and ∫ f² over [0,1]^D
//   template <class R> Panels<R> panels_x() const;                     of the (outer) integral over x
//   template <class R> Panels<R> panels_y(const R& x) const;           D = 2: of the inner integral over y at this x
// and inherits the panels when it is analytic throughout.
struct Formula1D {
    static constexpr int dimension = 1;
    template <class R>
    Panels<R> panels_x() const {
        return equal_panels<R>(1);
    }
};
struct Formula2D {
    static constexpr int dimension = 2;
    template <class R>
    Panels<R> panels_x() const {
        return equal_panels<R>(1);
    }
    template <class R>
    Panels<R> panels_y(const R&) const {
        return equal_panels<R>(1);
    }
};

}  // namespace plumb::formulas
