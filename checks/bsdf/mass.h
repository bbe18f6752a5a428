#pragma once

#include <functional>

#include "checks/bsdf/bsdf_subject.h"
#include "checks/bsdf/lobes.h"
#include "checks/bsdf/sphere_integral.h"

namespace plumb::checks {

/// An integral over the directions of wi, and what samples of wo met.
struct Mass {
    Met met;
    SphereIntegral integral;
    double
        rounding;  ///< relative, of the integral: one operation's worth of rounding_of(), on average over the samples

    [[nodiscard]] double total() const { return integral.total(); }
    [[nodiscard]] double error() const { return integral.error() + rounding * integral.total(); }
};

/// The integral of f(wo, wi), in parts of at most `largest`. Peaks are looked for where 2048 samples went, so that a
/// lobe of a thousandth of the probability is met twice, and at the mirrored and refracted directions, straight on,
/// back and along the normal, as far off as the traits' roughness. Where the error is above 4e-3 then, but not
/// hopeless, four times as many samples and evaluations are tried, and again.
Mass mass_of(const BsdfSubject& bsdf, const BsdfTraits& traits, const std::function<double(Vec3 wo, Vec3 wi)>& f,
             Vec3 wo, RandomStream& random, double epsilon, double largest = std::numeric_limits<double>::infinity());

}  // namespace plumb::checks
