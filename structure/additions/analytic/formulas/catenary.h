#pragma once

#include "analytic/formulas/formula.h"

namespace plumb::formulas {

struct Catenary : Formula1D {
    Description about() const {
        return {.id = "catenary",
                .formula = "(e^x + e^-x)/2",
                .smoothness = Smoothness::analytic,
                .periodic_smoothness = Smoothness::jump,
                .bounds = with_rounding(1, 1.5430806348152437),
                .source = "ours",
                .derivation = "sinh 1 = (e - 1/e)/2; cosh^2 = (1 + cosh 2x)/2 gives 1/2 + (e^2 - e^-2)/8"};
    }
    template <class R>
    R value(const std::array<R, 1>& x) const {
        return (exp(x[0]) + exp(R(-x[0]))) / 2;
    }
    template <class R>
    R integral() const {
        return (exp(R(1)) - exp(R(-1))) / 2;
    }
    template <class R>
    R second_moment() const {
        return R(1) / 2 + (exp(R(2)) - exp(R(-2))) / 8;
    }
};

}  // namespace plumb::formulas
