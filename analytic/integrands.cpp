#include "analytic/formulas/all.h"

namespace plumb {
namespace {

struct Pinned {
    std::string_view id, integral, variance;
};
constexpr Pinned pinned_answers[] = {
#include "analytic/pinned_answers.inc"
};

const Pinned& pinned(std::string_view id) {
    const auto found = std::ranges::find(pinned_answers, id, &Pinned::id);
    if (found == std::end(pinned_answers))
        throw std::logic_error(fmt::format("integrand '{}' has no pinned answers: run pin_answers", id));
    return *found;
}

template <int D>
std::vector<Integrand<D>> all_integrands() {
    std::vector<Integrand<D>> integrands;
    formulas::visit_formulas<D>([&](const auto& formula) {
        const formulas::Description about = formula.about();
        const Pinned& answers = pinned(about.id);
        integrands.push_back(
            {.id = about.id,
             .formula = about.formula,
             .value = [formula](const Point<D>& x) { return formula.value(x); },
             .integral = std::string(answers.integral),
             .variance = std::string(answers.variance),
             .smoothness = about.smoothness,
             .periodic_smoothness = about.periodic_smoothness,
             .bounds = about.bounds,
             .source = about.source,
             .derivation = fmt::format("{}. Checked by two quadratures: integrand/{}d/*", about.derivation, D)});
    });
    return integrands;
}

}  // namespace

const std::vector<Integrand<1>>& integrands_1d() {
    static const std::vector<Integrand<1>> integrands = all_integrands<1>();
    return integrands;
}

const std::vector<Integrand<2>>& integrands_2d() {
    static const std::vector<Integrand<2>> integrands = all_integrands<2>();
    return integrands;
}

}  // namespace plumb
