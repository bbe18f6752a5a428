#pragma once

#include "analytic/formulas/edges.h"
#include "analytic/formulas/exponentials.h"
#include "analytic/formulas/genz.h"
#include "analytic/formulas/keister.h"
#include "analytic/formulas/kinks.h"
#include "analytic/formulas/oscillating.h"
#include "analytic/formulas/periodic.h"
#include "analytic/formulas/polynomials.h"
#include "analytic/formulas/singular.h"
#include "analytic/formulas/test_image.h"
#include "analytic/formulas/thesis.h"

namespace plumb::formulas {

inline void visit_1d(const auto& visit) {
    visit(Monomial("constant", 0));
    visit(Monomial("linear", 1));
    visit(Monomial("square", 2));
    visit(Monomial("cubic", 3));
    visit(Monomial("quintic", 5));
    visit(Parabola());
    visit(Exponential());
    visit(Sine());
    visit(PeriodicExponential());
    visit(PeriodicRational());
    visit(Oscillating());
    visit(Aliasing());
    visit(Spike());
    visit(Cancellation());
    visit(Kink());
    visit(Step());
    visit(Thesis());
    visit(Keister());
    visit(Logarithm());
    visit(InversePower("inverse-sqrt", 5));
    visit(InversePower("inverse-power-0.9", 9));
    visit_genz_1d(visit);
}

inline void visit_2d(const auto& visit) {
    visit(Constant2D());
    visit(Product());
    visit(Polynomial2D());
    visit(Parabola2D());
    visit(ExponentialSum());
    visit(Gaussian2D());
    visit(PeriodicExponential2D());
    visit(Oscillating2D());
    visit(Aliasing2D());
    visit(Spike2D());
    visit(Cancellation2D());
    visit(Kink2D());
    visit(Step2D());
    visit(Edge());
    visit(Triangle());
    visit(QuarterDisk());
    visit(Disk());
    visit(CutDisk());
    visit(TestImage());
    visit(Keister2D());
    visit(LogarithmOfProduct());
    visit(InverseDistance());
    visit_genz_2d(visit);
}

/// Calls visit(formula) for every formula of dimension D, in the order of the report.
template <int D>
void visit_formulas(const auto& visit) {
    if constexpr (D == 1)
        visit_1d(visit);
    else
        visit_2d(visit);
}

}  // namespace plumb::formulas
