#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "checks/bsdf/bsdf_subject.h"
#include "verification/run.h"
#include "verification/verdict.h"

namespace plumb::checks {

// Each of these verdicts takes its directions from the run's seed. "Bounded" ones allow for the rounding of the
// model's arithmetic and for the error of their own quadrature, and say how much that is where it matters.

/// The values are sound: eval(), pdf() and what sample() gives are finite and not negative, at wi = ±wo, at mirror
/// images and within the surface too, directions have unit length, eval() is 0 where pdf() is, and sample() scatters
/// where pdf() says so. Undecided for a model that never scatters.
Verdict values_are_sound(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);

/// sample() follows pdf() at each of 25 directions: a chi-square each, in cells of about equal mass; discrete and lost
/// samples are cells. Half of the samples are of radiance, half of importance.
Verdict samples_follow_pdf(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);
/// pdf() is 1/Jacobian of sample() by differences, times the lobe's share of u[0]; where two smooth lobes may overlap,
/// at least that.
Verdict pdf_is_inverse_jacobian(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);
/// A smooth sample carries pdf = pdf() and weight = eval()/pdf(), a discrete one its share of u[0] and a weight that
/// does not depend on u[1] and u[2], in both transports.
Verdict weight_is_eval_over_pdf(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);
/// ∫ pdf and discrete() are the shares of [0,1)³ that sample() takes to smooth and discrete lobes, in both transports;
/// the rest is lost. At every third of 25 directions and the grazing ones.
Verdict masses_match(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);
/// eval(wo, wi, radiance)/|wi.z| = eval(wi, wo, importance)/|wo.z|, and radiance obeys f/eta² reciprocity. A discrete
/// sample's direction leads back to wo, with the same reflectance, and all refracted ones obey Snell's law about one
/// normal.
Verdict is_reciprocal(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);
/// A sample's radiance weight is its importance weight divided by eta² of the sides, eta as the traits say.
Verdict radiance_scales_by_eta_squared(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);
/// The albedo for importance is at most 1, and exactly 1, within the tolerance, from above where the model is lossless,
/// at 25 directions. For a coloured model the largest lane counts at each direction.
Verdict conserves_energy(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run, double tolerance = 1e-3);

/// The verdict on one property of a model.
struct NamedVerdict {
    std::string property;
    Verdict verdict;
};
std::ostream& operator<<(std::ostream& out, const NamedVerdict& named);  ///< "property: " and describe(verdict)

/// The verdicts on all of these properties: values, sample, pdf, weight, mass, reciprocity, eta-squared and energy.
/// Where the values are refuted, the others are not tried, and are undecided.
std::vector<NamedVerdict> check_bsdf(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);

/// The same verdicts for any type with eval, pdf and sample under the conventions of scenes/bsdfs/bsdf_model.h. A true
/// model is refuted with probability at most run.alpha().
template <class Model>
requires(!std::same_as<Model, BsdfSubject>) std::vector<NamedVerdict> check_bsdf(
    const Model& model, const BsdfTraits& traits = {}, const Run& run = Run(1, "check_bsdf", 1e-4)) {
    return check_bsdf(subject_of(model), traits, run);
}

}  // namespace plumb::checks
