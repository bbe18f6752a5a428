#include "checks/bsdf/check_bsdf.h"

#include <ostream>

namespace plumb::checks {

std::ostream& operator<<(std::ostream& out, const NamedVerdict& named) {
    return out << named.property << ": " << named.verdict;
}

std::vector<NamedVerdict> check_bsdf(const BsdfSubject& bsdf, const BsdfTraits& traits, const Run& run) {
    const std::vector<std::pair<std::string, std::function<Verdict(const Run&)>>> others{
        {"sample", [&](const Run& part) { return samples_follow_pdf(bsdf, traits, part); }},
        {"pdf", [&](const Run& part) { return pdf_is_inverse_jacobian(bsdf, traits, part); }},
        {"weight", [&](const Run& part) { return weight_is_eval_over_pdf(bsdf, traits, part); }},
        {"mass", [&](const Run& part) { return masses_match(bsdf, traits, part); }},
        {"reciprocity", [&](const Run& part) { return is_reciprocal(bsdf, traits, part); }},
        {"eta-squared", [&](const Run& part) { return radiance_scales_by_eta_squared(bsdf, traits, part); }},
        {"energy", [&](const Run& part) { return conserves_energy(bsdf, traits, part); }}};
    std::vector<NamedVerdict> all{{"values", values_are_sound(bsdf, traits, run.part("values"))}};
    const bool sound = all[0].verdict.outcome != Outcome::refuted;
    for (const auto& [property, check] : others) {
        Verdict verdict;
        verdict.reason = "not tried, because the values are refuted";
        all.push_back({property, sound ? check(run.part(property)) : verdict});
    }
    return all;
}

}  // namespace plumb::checks
