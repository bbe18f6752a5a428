#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "analytic/formulas/formula.h"
#include "analytic/quadrature.h"

namespace plumb {

/// Nodes in [0,1] and weights, for an integral over [0,1].
template <class R>
struct Rule {
    std::vector<R> node, weight;
};

/// n nodes, exact for polynomials up to the degree 2n − 1. Newton's iteration on the Legendre polynomial.
template <class R>
Rule<R> gauss_legendre(int n) {
    using std::abs;
    Rule<R> rule;
    for (int k = 0; k < n; ++k) {
        R x = -std::cos(formulas::pi<double>() * (k + 0.75) / (n + 0.5)), slope, step = 1;
        for (bool last = false; !last;) {  // one more step once half of the digits stand
            last = abs(step) < sqrt(std::numeric_limits<R>::epsilon());
            R below = 1, p = x;
            for (int j = 2; j <= n; ++j) {
                const R next = ((2 * j - 1) * x * p - (j - 1) * below) / j;
                below = p;
                p = next;
            }
            slope = n * (x * p - below) / (x * x - 1);
            step = p / slope;
            x -= step;
        }
        rule.node.push_back((1 + x) / 2);
        rule.weight.push_back(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

/// The trapezoidal rule of this step after t = 1/(1 + exp(−π sinh s)), from t = 10^−digits to 1 − 10^−digits
/// [Takahasi & Mori 1974].
template <class R>
Rule<R> tanh_sinh(int nodes_per_unit, double digits) {
    const R pi = formulas::pi<R>();
    const int last = static_cast<int>(nodes_per_unit * std::asinh(digits * std::log(10.) / formulas::pi<double>()));
    Rule<R> rule;
    for (int k = -last; k <= last; ++k) {
        const R up = exp(R(R(k) / nodes_per_unit)), sinh = (up - 1 / up) / 2, cosh = (up + 1 / up) / 2;
        const R odds = exp(R(pi * sinh)), t = odds / (1 + odds);  // of t against 1 − t
        rule.node.push_back(t);
        rule.weight.push_back(pi * cosh * t / (1 + odds) / nodes_per_unit);
    }
    return rule;
}

/// The rule, panel by panel, in s after t = e^−s, from t = 1 to 10^−digits: for singularities at 0.
template <class R>
Rule<R> logarithmic(const Rule<R>& rule, double digits) {
    Rule<R> result;
    double width = 4;
    for (double s = 0; s < digits * std::log(10.); s += width, width *= 2)
        for (std::size_t i = 0; i < rule.node.size(); ++i) {
            const R t = exp(R(-(s + width * rule.node[i])));
            result.node.push_back(t);
            result.weight.push_back(width * rule.weight[i] * t);
        }
    return result;
}

/// The rules of one quadrature that a formula's panels need, to about `digits` digits with `order` nodes:
/// Gauss–Legendre nodes a panel, or tanh-sinh nodes a unit of s.
template <class R>
class RuleBook {
public:
    RuleBook(Quadrature method, int order, double digits)
        : method_(method),
          order_(order),
          digits_(digits),
          regular_(method == Quadrature::gauss_legendre ? gauss_legendre<R>(order) : tanh_sinh<R>(order, digits)) {}

    const Rule<R>& rule(const formulas::Panel<R>& panel) {
        if (panel.singular == formulas::Singular::nowhere) return regular_;
        const auto [found, is_new] = singular_.try_emplace(panel.mass_exponent);
        if (is_new) {
            const double digits = digits_ / panel.mass_exponent;
            found->second =
                method_ == Quadrature::gauss_legendre ? logarithmic(regular_, digits) : tanh_sinh<R>(order_, digits);
        }
        return found->second;
    }

private:
    Quadrature method_;
    int order_;
    double digits_;
    Rule<R> regular_;
    std::map<double, Rule<R>> singular_;
};

/// ∫ visit over the panels: calls visit(x, weight) for every node.
template <class R, class Visit>
void visit_nodes(const formulas::Panels<R>& panels, RuleBook<R>& book, const Visit& visit) {
    for (const auto& panel : panels) {
        const Rule<R>& rule = book.rule(panel);
        const R length = panel.to - panel.from;
        const bool from_above = panel.singular == formulas::Singular::high;
        for (std::size_t i = 0; i < rule.node.size(); ++i) {
            const R distance = length * rule.node[i];
            visit(from_above ? R(panel.to - distance) : R(panel.from + distance), R(length * rule.weight[i]));
        }
    }
}

/// ∫ f and ∫ f² of a formula over the unit cube.
template <class R>
struct FirstMoments {
    R mean = 0, square = 0;
};
template <class R, class Formula>
FirstMoments<R> integrate(const Formula& formula, RuleBook<R>& book) {
    FirstMoments<R> sum;
    const auto add = [&](const R& value, const R& weight) {
        sum.mean += weight * value;
        sum.square += weight * value * value;
    };
    visit_nodes(formula.template panels_x<R>(), book, [&](const R& x, const R& weight) {
        if constexpr (Formula::dimension == 1)
            add(formula.value(std::array<R, 1>{x}), weight);
        else
            visit_nodes(formula.panels_y(x), book, [&](const R& y, const R& weight_y) {
                add(formula.value(std::array<R, 2>{x, y}), R(weight * weight_y));
            });
    });
    return sum;
}

}  // namespace plumb
