#include "scenes/bsdfs/roughdielectric.h"

#include "scenes/bsdfs/fresnel.h"

namespace plumb {
namespace {

// What happens at a facet, seen from above: wo.z > 0, and `across` is the index below over the index above.
struct Facet {
    Vec3 m;
    double cos_o, cos_i;  // wo·m > 0; wi·m, negative for refraction
    double reflectance;
    double half_jacobian;  // |dm/dwi|: [Walter et al. 2007, eq. 14, 17]
};

Facet facet_between(Vec3 wo, Vec3 wi, Vec3 m, double across) {
    const double cos_o = dot(wo, m), cos_i = dot(wi, m);
    const double sum = cos_o + across * cos_i;
    const double half_jacobian = wi.z > 0 ? 1 / (4 * std::abs(cos_o)) : across * across * std::abs(cos_i) / (sum * sum);
    return {m, cos_o, cos_i, cos_o > 0 ? fresnel_dielectric(cos_o, across).reflectance : 0, half_jacobian};
}

// The facet whose normal takes wo to wi.
Facet facet_between(Vec3 wo, Vec3 wi, double across) {
    const Vec3 half = wi.z > 0 ? wo + wi : wo + across * wi;
    return facet_between(wo, wi, normalize(half.z > 0 ? half : -half), across);
}

bool sees(const Facet& facet, Vec3 wi) {
    return facet.cos_o > 0 && facet.cos_i * wi.z > 0;
}

double chance(const Facet& facet, Vec3 wi) {
    return wi.z > 0 ? facet.reflectance : 1 - facet.reflectance;
}

double radiance_scale(Vec3 wi, double across, Transport transport) {
    return wi.z < 0 && transport == Transport::radiance ? 1 / (across * across) : 1;
}

}  // namespace

// In terms of the facets that wo sees: f |wi.z| = chance · visible_pdf · |dm/dwi| · G1(wi), which is
// [Walter et al. 2007, eq. 20, 21] for particles; radiance takes 1/across² more when it passes.
Spectrum RoughDielectric::eval(Vec3 wo, Vec3 wi, Transport transport) const {
    if (wo.z == 0 || wi.z == 0) return {};
    const double across = wo.z > 0 ? eta : 1 / eta;
    if (wo.z < 0) wi = {wi.x, wi.y, -wi.z}, wo = {wo.x, wo.y, -wo.z};
    const Facet facet = facet_between(wo, wi, across);
    if (!sees(facet, wi)) return {};
    return (wi.z > 0 ? reflectance : transmittance) *
           (chance(facet, wi) * facets.visible_pdf(wo, facet.m) * facet.half_jacobian * facets.g1(wi, facet.m) *
            radiance_scale(wi, across, transport));
}

double RoughDielectric::pdf(Vec3 wo, Vec3 wi) const {
    if (wo.z == 0 || wi.z == 0) return 0;
    const double across = wo.z > 0 ? eta : 1 / eta;
    if (wo.z < 0) wi = {wi.x, wi.y, -wi.z}, wo = {wo.x, wo.y, -wo.z};
    const Facet facet = facet_between(wo, wi, across);
    return sees(facet, wi) ? chance(facet, wi) * facets.visible_pdf(wo, facet.m) * facet.half_jacobian : 0;
}

std::optional<BsdfSample> RoughDielectric::sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const {
    if (wo.z == 0) return {};
    const double side = std::copysign(1.0, wo.z), across = wo.z > 0 ? eta : 1 / eta;
    wo.z *= side;
    const Vec3 m = facets.sample_visible(wo, {u[1], u[2]});
    const double cosine = dot(wo, m);
    const auto [fresnel, cos_t] = fresnel_dielectric(cosine, across);
    const bool reflects = u[0] < fresnel;
    const Vec3 wi = reflects ? mirrored(wo, m) : (cosine / across - cos_t) * m - wo / across;
    const Facet facet = facet_between(wo, wi, m, across);
    if (!((reflects ? wi.z > 0 : wi.z < 0) && sees(facet, wi))) return {};
    return BsdfSample{
        {wi.x, wi.y, wi.z * side},
        (reflects ? reflectance : transmittance) * (facets.g1(wi, m) * radiance_scale(wi, across, transport)),
        chance(facet, wi) * facets.visible_pdf(wo, m) * facet.half_jacobian,
        Measure::solid_angle,
        reflects ? 1 : across,
        facets.alpha};
}

}  // namespace plumb
