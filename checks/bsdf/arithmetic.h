#pragma once

#include <functional>

#include "checks/bsdf/bsdf_subject.h"
#include "core/random.h"
#include "verification/run.h"

namespace plumb::checks {

// What rounding does to a model. Its unit is epsilon, the relative error of one operation: 2^-53 in doubles, 2^-24 in
// floats.

/// The epsilon that the model computes with: the traits', or that of floats when all directions, or all densities, that
/// it samples are floats.
double epsilon_of(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);

/// Arguments as a model of that epsilon takes them, so that it need not round them.
Vec3 representable(Vec3 w, double epsilon);
double representable(double u, double epsilon);  ///< u in [0,1), rounded down
std::array<double, 3> uniforms(RandomStream& random, double epsilon);

/// What is asked of equal numbers that rounding alone may part: `for_doubles`, or 64 epsilon where that is more.
double resolution(double for_doubles, double epsilon);

inline constexpr double rounding_operations = 8;

/// The relative error that rounding within f may have at (wo, wi). A formula takes its lobe's angle from a cosine, and
/// a cosine known to epsilon is an angle known to √epsilon at the lobe's peak: so what counts is how f changes over
/// steps h = √epsilon. With l = ln f the error is epsilon ∂l/∂cos, which is l″ epsilon where f is even about the lobe's
/// axis and at most (l″ + l′²) epsilon elsewhere: the sum over two tangents of each direction of |second difference| +
/// (first difference)², and one epsilon, times the number of operations. Infinite next to where f is 0.
double rounding_of(const std::function<double(Vec3 wo, Vec3 wi)>& f, Vec3 wo, Vec3 wi, double epsilon);

}  // namespace plumb::checks
