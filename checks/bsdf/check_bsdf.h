#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "checks/bsdf/bsdf_subject.h"
#include "checks/bsdf/directions.h"
#include "verification/run.h"
#include "verification/verdict.h"

namespace plumb::checks {

/// The properties of a model that the checks must know.
struct BsdfTraits {
    double roughness = 1;   ///< of its narrowest smooth lobe, as Beckmann's or Trowbridge's alpha in [1e-6, 1]
    double eta = 1;         ///< index inside over index outside, where it refracts
    bool lossless = false;  ///< all that arrives from above leaves again
};

// Each of these verdicts covers every one of check_directions(). "Bounded" ones state their bound in the reason.

/// The values are sound: eval(), pdf() and what sample() gives are finite and not negative, directions have unit
/// length, eval() is 0 where pdf() is, and sample() scatters where pdf() says so. Undecided for a model that never
/// scatters.
Verdict values_are_sound(const BsdfSubject& bsdf, const Run& run);

/// sample() follows pdf(): one chi-square over all directions at once, in cells of about equal mass that follow the
/// lobes; discrete and lost samples are cells.
Verdict samples_follow_pdf(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);
/// pdf() is 1/Jacobian of sample() by differences, times the lobe's share of u[0]; where two smooth lobes overlap, at
/// least that.
Verdict pdf_is_inverse_jacobian(const BsdfSubject& bsdf);
/// A smooth sample carries pdf = pdf() and weight = eval()/pdf(), a discrete one its share of u[0], in both transports.
Verdict weight_is_eval_over_pdf(const BsdfSubject& bsdf, const Run& run);
/// ∫ pdf and discrete() are the shares of [0,1)³ that sample() takes to smooth and discrete lobes; the rest is lost.
Verdict masses_match(const BsdfSubject& bsdf, const BsdfTraits& traits);
/// eval(wo, wi, radiance)/|wi.z| = eval(wi, wo, importance)/|wo.z|, and radiance obeys f/eta² reciprocity.
Verdict is_reciprocal(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);
/// A sample's radiance weight is its importance weight divided by eta² of the sides, eta as the traits say.
Verdict radiance_scales_by_eta_squared(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run);
/// The albedo for importance is at most 1, and exactly 1, within the tolerance, from above where the model is lossless.
/// For a coloured model the largest lane counts at each direction.
Verdict conserves_energy(const BsdfSubject& bsdf, const BsdfTraits& traits, double tolerance = 1e-3);

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
