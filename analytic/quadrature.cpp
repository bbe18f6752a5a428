#include "analytic/quadrature.h"

#include <stdexcept>

#include "analytic/formulas/all.h"
#include "analytic/quadrature_rules.h"
#include "analytic/real.h"

namespace plumb {
namespace {

// 2D asks for 1e-15: 34 digits and 20 of truncation cost a tenth of the time that 80 and 60 would.
template <int D>
using Number = std::conditional_t<D == 1, Real, Decimal<34>>;

template <int D>
RuleBook<Number<D>> rule_book(Quadrature method) {
    if (method == Quadrature::gauss_legendre) return {method, D == 1 ? 80 : 24, D == 1 ? 60. : 20.};
    return {method, D == 1 ? 40 : 12, D == 1 ? 60. : 20.};
}

template <int D>
QuadratureError error_of(const Integrand<D>& stated, const FirstMoments<Number<D>>& found) {
    using R = Number<D>;
    const R integral(stated.integral);
    if (stated.variance == "inf")
        return {stated.id, static_cast<double>(R(abs(R(integral - found.mean)) / abs(integral))), 0};
    const R second = R(stated.variance) + integral * integral;
    return {stated.id, static_cast<double>(R(abs(R(integral - found.mean)) / sqrt(second))),
            static_cast<double>(R(abs(R(second - found.square)) / second))};
}

template <int D>
void with_formula(std::string_view id, const auto& use) {
    bool found = false;
    formulas::visit_formulas<D>([&](const auto& formula) {
        if (found || formula.about().id != id) return;
        found = true;
        use(formula);
    });
    if (!found) throw std::logic_error(fmt::format("no formula of the id '{}'", id));
}

}  // namespace

std::string to_string(Quadrature method) {
    return method == Quadrature::gauss_legendre ? "Gauss-Legendre" : "tanh-sinh";
}

template <int D>
std::vector<QuadratureError> quadrature_errors(std::span<const Integrand<D>> stated, Quadrature method) {
    RuleBook<Number<D>> book = rule_book<D>(method);
    std::vector<QuadratureError> errors;
    for (const Integrand<D>& integrand : stated)
        with_formula<D>(integrand.id, [&](const auto& formula) {
            errors.push_back(error_of<D>(integrand, integrate(formula, book)));
        });
    return errors;
}
template std::vector<QuadratureError> quadrature_errors<1>(std::span<const Integrand<1>>, Quadrature);
template std::vector<QuadratureError> quadrature_errors<2>(std::span<const Integrand<2>>, Quadrature);

template <int D>
double correctly_rounded(std::string_view id, const Point<D>& x) {
    std::array<Number<D>, D> point;
    std::ranges::copy(x, point.begin());
    double value = 0;
    with_formula<D>(id, [&](const auto& formula) { value = static_cast<double>(formula.value(point)); });
    return value;
}
template double correctly_rounded<1>(std::string_view, const Point<1>&);
template double correctly_rounded<2>(std::string_view, const Point<2>&);

}  // namespace plumb
