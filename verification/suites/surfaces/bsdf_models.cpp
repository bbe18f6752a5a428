// Every surface on trial by checks/bsdf/check_bsdf.h, at every roughness, with the defects that renderers have had.

#include <algorithm>
#include <memory>
#include <numbers>

#include "scenes/bsdfs/bsdf.h"
#include "scenes/bsdfs/fresnel.h"
#include "verification/claim.h"
#include "verification/suites/surfaces/bsdf_defects.h"

namespace plumb::suites {
namespace {

using checks::BsdfSubject, checks::BsdfTraits, checks::subject_of;
using U = std::array<double, 3>;

using Subject = SurfaceSubject;
// Made when a check runs: some need tables.
using Subjects = std::function<std::vector<Subject>(const Run&)>;
using Property = std::function<Verdict(const BsdfSubject&, const BsdfTraits&, const Run&)>;

struct Model {
    std::string id, title, source;
    Subjects subjects;
    std::vector<std::string> properties;
    std::vector<NamedDefect> defects;
};

struct PropertyOfAll {
    std::string id, statement;
    Kind kind;
    Property check;
};

const std::vector<PropertyOfAll>& properties() {
    static const std::vector<PropertyOfAll> all{
        {"sample", "samples follow pdf() from 25 directions, those at grazing incidence and from inside included",
         Kind::distribution, checks::samples_follow_pdf},
        {"pdf", "pdf() is 1/Jacobian of sample(), times the share of its lobe", Kind::bounded,
         checks::pdf_is_inverse_jacobian},
        {"weight", "a sample's weight is eval()/pdf(), or its lobe's share where it is discrete", Kind::bounded,
         checks::weight_is_eval_over_pdf},
        {"mass", "continuous, discrete and lost mass sum to 1", Kind::bounded, checks::masses_match},
        {"reciprocity", "f/eta² is symmetric, and radiance is the adjoint of importance", Kind::bounded,
         checks::is_reciprocal},
        {"eta-squared", "what is refracted scales by 1/eta² as radiance and not as importance", Kind::bounded,
         checks::radiance_scales_by_eta_squared},
        {"energy", "no more importance leaves than arrives, and exactly as much where the model says so", Kind::bounded,
         [](const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
             return checks::conserves_energy(bsdf, traits, run);
         }},
    };
    return all;
}

const std::vector<std::string> all_properties{"sample",      "pdf",         "weight", "mass",
                                              "reciprocity", "eta-squared", "energy"};
const std::vector<std::string> discrete_properties{"weight", "mass", "eta-squared", "energy"};

Verdict on_all(const std::vector<Subject>& subjects, const Property& check, const Run& run) {
    std::vector<Verdict> verdicts;
    for (const Subject& subject : subjects) {
        Verdict verdict =
            check(subject.bsdf, subject.traits, run.part(subject.name, 1 / static_cast<double>(subjects.size())));
        verdict.reason = subject.name + ": " + verdict.reason;
        verdicts.push_back(std::move(verdict));
    }
    return all_of(std::move(verdicts));
}

std::vector<NamedDefect> with(std::vector<NamedDefect> defects, std::vector<NamedDefect> more) {
    defects.insert(defects.end(), more.begin(), more.end());
    return defects;
}

// ---- defects of one model

// In full all those of the shipped scenes are among them.
std::vector<double> roughnesses(const Run& run) {
    return run.pick<std::vector<double>>({1e-4, 0.05, 0.1, 0.3, 1},
                                         {1e-4, 0.005, 0.02, 0.05, 0.08, 0.1, 0.15, 0.2, 0.3, 1});
}

double alpha_of(const Subject& s) {
    return s.traits.roughness;
}

RoughConductor metal(MicrofacetShape shape, double alpha) {
    return {{shape, alpha}, Spectrum::rgb(0.2, 0.9, 1.1), Spectrum::rgb(3.1, 2.2, 2.1)};
}

Defect without_half_vector_jacobian() {
    return [](const Subject& s) {
        BsdfSubject bad = s.bsdf;
        bad.pdf = [right = s.bsdf.pdf](Vec3 wo, Vec3 wi) {
            return wi.z > 0 ? right(wo, wi) * 4 * dot(wo, normalize(wo + wi)) : 0;
        };
        return bad;
    };
}

BsdfSubject beckmann_pdf_of_ggx_samples(const Subject& s) {
    BsdfSubject bad = s.bsdf;
    bad.pdf = subject_of(metal(MicrofacetShape::beckmann, alpha_of(s))).pdf;
    return bad;
}

// Normals with density D m.z [Walter et al. 2007, eq. 35], but the weight F G1(wi) of visible ones.
BsdfSubject visible_weight_of_plain_samples(const Subject& s) {
    const RoughConductor bsdf = metal(MicrofacetShape::ggx, alpha_of(s));
    BsdfSubject bad = s.bsdf;
    bad.pdf = [bsdf](Vec3 wo, Vec3 wi) {
        if (!(wo.z > 0 && wi.z > 0)) return 0.0;
        const Vec3 m = normalize(wo + wi);
        return bsdf.facets.d(m) * m.z / (4 * dot(wo, m));
    };
    bad.sample = [bsdf, pdf = bad.pdf](Vec3 wo, const U& u, Transport) -> std::optional<BsdfSample> {
        if (!(wo.z > 0)) return {};
        const double alpha = bsdf.facets.alpha, tangent = alpha * std::sqrt(u[1] / (1 - u[1]));
        const double phi = 2 * std::numbers::pi * u[2];
        const Vec3 m = normalize({tangent * std::cos(phi), tangent * std::sin(phi), 1});
        const Vec3 wi = mirrored(wo, m);
        if (!(wi.z > 0 && dot(wo, m) > 0)) return {};
        const Spectrum weight =
            bsdf.reflectance * fresnel_conductor(dot(wo, m), bsdf.eta, bsdf.k) * bsdf.facets.g1(wi, m);
        return BsdfSample{wi, weight, pdf(wo, wi), Measure::solid_angle, 1, alpha};
    };
    return bad;
}

BsdfSubject refraction_jacobian_without_eta(const Subject& s) {
    BsdfSubject bad = s.bsdf;
    const double eta = s.traits.eta;
    bad.pdf = [eta, right = s.bsdf.pdf](Vec3 wo, Vec3 wi) {
        return right(wo, wi) * (same_side(wo, wi) ? 1 : wo.z > 0 ? 1 / (eta * eta) : eta * eta);
    };
    return bad;
}

BsdfSubject not_turned_back(const Subject& s) {
    return with_samples(s, [](BsdfSample& sample, Vec3, Transport) { sample.wi.z = std::abs(sample.wi.z); });
}

// A plastic whose base returns a share of what it should: all but the mirror, which is discrete.
Defect base_scaled(double factor) {
    return [=](const Subject& s) {
        BsdfSubject bad = s.bsdf;
        bad.eval = [=, right = s.bsdf.eval](Vec3 wo, Vec3 wi, Transport t) { return right(wo, wi, t) * factor; };
        return bad;
    };
}

// ---- the models

std::vector<Subject> rough_conductors(MicrofacetShape shape, const Run& run) {
    std::vector<Subject> subjects;
    for (const double alpha : roughnesses(run))
        subjects.push_back({fmt::format("alpha {}", alpha), subject_of(metal(shape, alpha)), {alpha}});
    return subjects;
}

std::vector<Subject> rough_dielectrics(MicrofacetShape shape, const Run& run) {
    std::vector<Subject> subjects;
    for (const double alpha : roughnesses(run))
        subjects.push_back(
            {fmt::format("alpha {}", alpha), subject_of(RoughDielectric{{shape, alpha}, 1.5}), {alpha, 1.5}});
    return subjects;
}

std::vector<Subject> rough_plastics(MicrofacetShape shape, const Run& run) {
    std::vector<Subject> subjects;
    for (const double alpha : roughnesses(run)) {
        if (alpha < 0.005) continue;  // a coat's table and its base's lobe need no sharper one
        const auto coat = std::make_shared<RoughTransmittance>(Microfacets{shape, alpha}, 1.5);
        BsdfSubject bsdf = subject_of(RoughPlastic(Spectrum::grey(1), *coat, true));
        bsdf.discrete = [coat](Vec3) { return 0.0; };  // which also keeps the table alive
        subjects.push_back({fmt::format("alpha {}", alpha), std::move(bsdf), {alpha}});
    }
    return subjects;
}

std::vector<Model> models() {
    const auto one = [](const auto& bsdf, BsdfTraits traits) {
        return [=](const Run&) { return std::vector<Subject>{{"it", subject_of(bsdf), traits}}; };
    };
    const auto shaped = [](auto make, MicrofacetShape shape) {
        return [=](const Run& run) { return make(shape, run); };
    };
    const std::vector<NamedDefect> refraction{
        {"eta-squared", "missing", "Refracted radiance is not scaled.", eta_squared_missing},
        {"eta-squared", "upside-down", "Refracted radiance scales by eta².", eta_squared_upside_down},
        {"eta-squared", "both-sides", "Importance scales by 1/eta² too.", eta_squared_on_both_sides}};
    const std::vector<NamedDefect> rough_refraction =
        with(refraction,
             {{"reciprocity", "swapped", "wo and wi change places.", eval_swapped},
              {"reciprocity", "eta-squared-missing", "Refracted radiance is not scaled.", eta_squared_missing},
              {"weight", "transmission-doubled", "A factor 2 in the lobe of transmission.", transmission_doubled},
              {"energy", "transmission-doubled", "A factor 2 in the lobe of transmission.", transmission_doubled},
              {"pdf", "eta-squared-missing", "Refraction's half-vector Jacobian lacks eta².",
               refraction_jacobian_without_eta},
              {"mass", "eta-squared-missing", "Refraction's half-vector Jacobian lacks eta².",
               refraction_jacobian_without_eta}});
    const std::vector<NamedDefect> rough_reflection{
        {"pdf", "no-jacobian", "The density is per steradian of half vectors.", without_half_vector_jacobian()},
        {"mass", "no-jacobian", "The density is per steradian of half vectors.", without_half_vector_jacobian()}};
    const std::vector<NamedDefect> ggx_reflection =
        with(rough_reflection,
             {{"sample", "beckmann-pdf", "Samples of GGX, density of Beckmann.", beckmann_pdf_of_ggx_samples},
              {"weight", "plain-samples", "Samples of all normals with the weight of visible ones.",
               visible_weight_of_plain_samples}});
    constexpr auto ggx = MicrofacetShape::ggx, beckmann = MicrofacetShape::beckmann;
    return {
        {"diffuse", "A diffuse surface", "Lambert", one(Diffuse{Spectrum::grey(1)}, {1, 1, true}), all_properties,
         common_defects(1.003)},
        {"conductor", "A smooth conductor that absorbs nothing", "ours, scenes/bsdfs/conductor.h",
         one(Conductor{}, {1, 1, true}), discrete_properties, discrete_defects()},
        {"dielectric", "A smooth dielectric", "ours, scenes/bsdfs/dielectric.h", one(Dielectric{1.5}, {1, 1.5, true}),
         discrete_properties,
         with(
             with(discrete_defects(), refraction),
             {{"weight", "chosen-too-often", "Lobes are chosen by u^1.1 but announce the probability of u.",
               chosen_too_often},
              {"energy", "eta-squared-on-importance", "Importance scales by 1/eta² too.", eta_squared_on_both_sides}})},
        {"thindielectric", "A pane without thickness", "ours, scenes/bsdfs/thindielectric.h",
         one(ThinDielectric{1.5}, {1, 1, true}), discrete_properties,
         with(discrete_defects(),
              {{"weight", "chosen-too-often", "Lobes are chosen by u^1.1 but announce the probability of u.",
                chosen_too_often}})},
        {"roughconductor-ggx", "A rough conductor of GGX facets", "[Walter et al. 2007; Dupuy & Benyoub 2023]",
         shaped(rough_conductors, ggx), all_properties, with(common_defects(2), ggx_reflection)},
        {"roughconductor-beckmann", "A rough conductor of Beckmann facets", "[Walter et al. 2007; Heitz & d'Eon 2014]",
         shaped(rough_conductors, beckmann), all_properties, with(common_defects(2), rough_reflection)},
        {"roughdielectric-ggx", "A rough dielectric of GGX facets", "[Walter et al. 2007; Dupuy & Benyoub 2023]",
         shaped(rough_dielectrics, ggx), all_properties, with(common_defects(2), rough_refraction)},
        {"roughdielectric-beckmann", "A rough dielectric of Beckmann facets",
         "[Walter et al. 2007; Heitz & d'Eon 2014]", shaped(rough_dielectrics, beckmann), all_properties,
         with(common_defects(2), rough_refraction)},
        {"plastic", "A smooth plastic with a white base", "Mitsuba's plastic; ours, scenes/bsdfs/plastic.h",
         one(Plastic(Spectrum::grey(1), SmoothCoat(1.5), true), {1, 1, true}), all_properties,
         with(common_defects(1.003),
              {{"energy", "outside-mean", "The coat reflects the base's light as it does light from outside.",
                base_scaled((1 - mean_fresnel_dielectric(1 / 1.5)) / (1 - mean_fresnel_dielectric(1.5)))},
               {"energy", "no-eta-squared", "The base's light is not spread over eta² more solid angle.",
                base_scaled(2.25)},
               {"weight", "share", "The weight is not divided by the lobe's probability.", weight_without_share}})},
        {"roughplastic-ggx", "A rough plastic of GGX facets with a white base",
         "Mitsuba's roughplastic; ours, scenes/bsdfs/roughplastic.h", shaped(rough_plastics, ggx), all_properties,
         with(defects_of_mixtures(1.01),
              {{"weight", "share", "The weight is not divided by the lobe's probability.", weight_without_share}})},
        {"roughplastic-beckmann", "A rough plastic of Beckmann facets with a white base",
         "Mitsuba's roughplastic; ours, scenes/bsdfs/roughplastic.h", shaped(rough_plastics, beckmann), all_properties,
         defects_of_mixtures(1.01)},
        {"twosided", "A two-sided diffuse surface", "ours, scenes/bsdfs/bsdf.h",
         one(Bsdf{Diffuse{Spectrum::grey(1)}, true}, {1, 1, true}), all_properties,
         with(common_defects(1.003),
              {{"sample", "not-turned-back", "A direction chosen below is returned above.", not_turned_back}})},
    };
}

/// The model of the middle roughness alone, with the defect.
Subjects with_defect(const Subjects& right, const Defect& apply) {
    return [=](const Run& run) {
        const std::vector<Subject> all = right(run);
        Subject subject = all[all.size() / 2];
        subject.bsdf = apply(subject);
        return std::vector<Subject>{subject};
    };
}

void add(Catalogue& catalogue, const Model& model, const PropertyOfAll& property) {
    std::vector<Wrong<Subjects>> wrong;
    for (const NamedDefect& defect : model.defects)
        if (defect.property == property.id)
            wrong.push_back({defect.id, defect.sentence, with_defect(model.subjects, defect.apply)});
    catalogue.add({.id = fmt::format("bsdf/{}/{}", model.id, property.id),
                   .statement = fmt::format("{}: {}.", model.title, property.statement),
                   .source = model.source,
                   .kind = property.kind,
                   .trial = {[check = property.check](const Subjects& subjects, const Run& run) {
                                 return on_all(subjects(run), check, run);
                             },
                             model.subjects, std::move(wrong)}});
}

}  // namespace

void add_surfaces_bsdf_models(Catalogue& catalogue) {
    for (const Model& model : models())
        for (const PropertyOfAll& property : properties())
            if (std::ranges::count(model.properties, property.id)) add(catalogue, model, property);
}

}  // namespace plumb::suites
