// Lunar dust on trial, as every surface is.

#include "scenes/bsdfs/lunar.h"
#include "checks/bsdf/check_bsdf.h"
#include "estimators/densities/warps.h"
#include "verification/claim.h"

namespace plumb::suites {
namespace {

using checks::BsdfSubject;

Verdict is_a_surface(const BsdfSubject& bsdf, const Run& run) {
    std::vector<Verdict> parts;
    for (checks::NamedVerdict& named : checks::check_bsdf(bsdf, {}, run)) {
        named.verdict.reason = named.property + ": " + named.verdict.reason;
        parts.push_back(std::move(named.verdict));
    }
    return all_of(std::move(parts));
}

BsdfSubject lunar() {
    return checks::subject_of(Lunar{Spectrum::grey(1)});
}

BsdfSubject with_pdf_of_lambert() {
    BsdfSubject bad = lunar();
    bad.pdf = [](Vec3 wo, Vec3 wi) { return wo.z > 0 ? cosine_hemisphere_pdf(wi) : 0; };
    return bad;
}

BsdfSubject by_one_cosine() {
    BsdfSubject bad = lunar();
    bad.eval = [](Vec3 wo, Vec3 wi, Transport) {
        return wo.z > 0 && wi.z > 0 ? Spectrum::grey(1 / (8 * pi * wo.z) * wi.z) : Spectrum();
    };
    return bad;
}

}  // namespace

void add_surfaces_lunar(Catalogue& catalogue) {
    catalogue.add({.id = "bsdf/lunar/model",
                   .statement =
                       "Lunar dust is sampled by its pdf, weighted by eval()/pdf, reciprocal, and gives back no "
                       "more than it gets.",
                   .source = "ours, scenes/bsdfs/lunar.h",
                   .kind = Kind::distribution,
                   .trial = {is_a_surface,
                             lunar(),
                             {{"pdf-of-lambert", "pdf() is that of another sampling", with_pdf_of_lambert()},
                              {"one-cosine", "the cosine with the light is left out below", by_one_cosine()}}}});
}

}  // namespace plumb::suites
