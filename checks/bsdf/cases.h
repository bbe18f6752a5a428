#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/spectrum.h"
#include "core/vec3.h"
#include "verification/verdict.h"

namespace plumb::checks {

/// One number that a model gave, and what it should be.
struct Case {
    const char* of = "";      ///< what the numbers are: "pdf() for 1/Jacobian"
    Vec3 wo, wi = {0, 0, 0};  ///< wi is zero where the number is of wo alone
    double found = 0, expected = 0;
    double error = 0;        ///< of found, in the unit of the verdict
    double known = 0;        ///< of the error: what rounding or quadrature may have put there
    bool one_sided = false;  ///< found may exceed what is expected, for a reason that is no defect
    const char* cause = "";  ///< said where found is a factor {} times what is expected
};

/// The case of two numbers that should be equal. Its error is relative: infinite where only one is 0.
Case equal(const char* of, Vec3 wo, Vec3 wi, double found, double expected);
/// The same of two spectra, by the lane that differs most, relative to the largest lane.
Case equal(const char* of, Vec3 wo, Vec3 wi, const Spectrum& found, const Spectrum& expected);

/// A number that a defect may have put between found and expected.
struct Factor {
    std::string name;
    std::function<double(Vec3 wo, Vec3 wi)> of;
};

/// What a verdict on cases asks, and what it says.
struct Demand {
    double bound;  ///< of each error beyond what is known
    std::string unit;
    double coarse;                     ///< what is known no better than this shows nothing
    std::string nothing;               ///< said where there is no case
    std::vector<Factor> factors = {};  ///< what found may be times the expected, besides a constant
};

/// The verdict that no case's error exceeds what is known by more than the bound. It shows both numbers of the worst
/// case and its directions in words, and, where found is one factor times what is expected in 19 of 20 cases, the
/// likely cause. Undecided where most cases are known too coarsely. NaN refutes.
Verdict judged(const std::vector<Case>& cases, const Demand& demand);

/// Runs cases_of(i) for i from 0 to count − 1 in parallel and joins what they return, in order.
std::vector<Case> gathered(std::size_t count, const std::function<std::vector<Case>(std::size_t)>& cases_of);

}  // namespace plumb::checks
