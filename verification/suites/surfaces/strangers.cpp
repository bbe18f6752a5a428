// check_bsdf itself on trial: the surfaces of strangers that it must not take for wrong, and those that it must.

#include "verification/claim.h"
#include "verification/suites/surfaces/strangers_surfaces.h"

namespace plumb::suites {
namespace {

using Surfaces = std::vector<StrangersSurface>;
using Property = std::function<Verdict(const checks::BsdfSubject&, const checks::BsdfTraits&, const Run&)>;

struct PropertyOfStrangers {
    std::string id, what;
    Kind kind;
    bool integrates;  // over all directions of wi: at the quick size of few surfaces
    Property check;
};

std::vector<PropertyOfStrangers> properties() {
    const auto energy = [](const checks::BsdfSubject& bsdf, const checks::BsdfTraits& traits, const Run& run) {
        return checks::conserves_energy(bsdf, traits, run);
    };
    return {{"values", "values", Kind::bounded, false, checks::values_are_sound},
            {"sample", "samples", Kind::distribution, true, checks::samples_follow_pdf},
            {"pdf", "densities", Kind::bounded, false, checks::pdf_is_inverse_jacobian},
            {"weight", "weights", Kind::bounded, false, checks::weight_is_eval_over_pdf},
            {"mass", "masses", Kind::bounded, true, checks::masses_match},
            {"reciprocity", "ways back", Kind::bounded, false, checks::is_reciprocal},
            {"energy", "albedos", Kind::bounded, true, energy}};
}

Verdict on_all(const PropertyOfStrangers& property, const Surfaces& surfaces, const Run& run) {
    Surfaces judged = surfaces;
    if (property.integrates && run.size() == Size::quick && surfaces.size() > 1)
        std::erase_if(judged, [](const StrangersSurface& surface) { return !surface.quick; });
    std::vector<Verdict> verdicts;
    for (const StrangersSurface& surface : judged) {
        const Run part = run.part(surface.id, 1 / static_cast<double>(judged.size()));
        Verdict verdict = property.check(surface.bsdf, surface.traits, part);
        verdict.reason = surface.id + ": " + verdict.reason;
        verdicts.push_back(std::move(verdict));
    }
    return all_of(std::move(verdicts));
}

}  // namespace

void add_surfaces_strangers(Catalogue& catalogue) {
    for (const PropertyOfStrangers& property : properties()) {
        std::vector<Wrong<Surfaces>> wrong;
        for (const WrongStrangersSurface& bad : wrong_surfaces_of_strangers())
            if (bad.property == property.id) wrong.push_back({bad.surface.id, bad.sentence, {bad.surface}});
        catalogue.add(
            {.id = "bsdf/strangers/" + property.id,
             .statement = fmt::format(
                 "The {} of lobes of exponents up to 10^6 in any direction, of cones, of mixtures with rare "
                 "mirrors, of stretched metals and of models in floats down to roughness 0.01 are found true.",
                 property.what),
             .source = "ours, checks/bsdf/check_bsdf.h",
             .kind = property.kind,
             .trial = {[property](const Surfaces& surfaces, const Run& run) { return on_all(property, surfaces, run); },
                       true_surfaces_of_strangers(), std::move(wrong)}});
    }
}

}  // namespace plumb::suites
