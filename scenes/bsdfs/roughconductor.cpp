#include "scenes/bsdfs/roughconductor.h"

#include "scenes/bsdfs/fresnel.h"

namespace plumb {

Spectrum RoughConductor::eval(Vec3 wo, Vec3 wi, Transport) const {
    if (!(wo.z > 0 && wi.z > 0)) return {};
    const Vec3 m = normalize(wo + wi);
    return reflectance * fresnel_conductor(dot(wo, m), eta, k) * (facets.d(m) * facets.g2(wo, wi, m) / (4 * wo.z));
}

double RoughConductor::pdf(Vec3 wo, Vec3 wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return 0;
    const Vec3 m = normalize(wo + wi);
    return facets.visible_pdf(wo, m) / (4 * dot(wo, m));
}

std::optional<BsdfSample> RoughConductor::sample(Vec3 wo, const std::array<double, 3>& u, Transport) const {
    if (!(wo.z > 0)) return {};
    const Vec3 m = facets.sample_visible(wo, {u[1], u[2]});
    const Vec3 wi = mirrored(wo, m);
    const double cosine = dot(wo, m);
    if (!(wi.z > 0 && cosine > 0)) return {};
    return BsdfSample{wi,
                      reflectance * fresnel_conductor(cosine, eta, k) * facets.g1(wi, m),
                      facets.visible_pdf(wo, m) / (4 * cosine),
                      Measure::solid_angle,
                      1,
                      facets.alpha};
}

Spectrum RoughConductor::albedo() const {
    return reflectance * fresnel_conductor(1, eta, k);
}

}  // namespace plumb
