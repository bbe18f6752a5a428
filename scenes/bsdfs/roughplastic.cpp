#include "scenes/bsdfs/roughplastic.h"

#include "estimators/densities/warps.h"
#include "scenes/bsdfs/fresnel.h"
#include "scenes/bsdfs/plastic.h"

namespace plumb {

RoughPlastic::RoughPlastic(const Spectrum& diffuse, const RoughTransmittance& coat, bool nonlinear)
    : diffuse_reflectance(diffuse),
      coat_(&coat),
      base_(interreflected(diffuse, coat.returned(), nonlinear) / (coat.eta() * coat.eta())),
      coat_share_(1 / (1 + largest(diffuse))) {}

double RoughPlastic::coat_probability(double cos_o) const {
    const double passed = coat_->at(cos_o);
    const double coat = (1 - passed) * coat_share_, base = passed * (1 - coat_share_);
    return coat / (coat + base);
}

Spectrum RoughPlastic::eval(Vec3 wo, Vec3 wi, Transport) const {
    if (!(wo.z > 0 && wi.z > 0)) return {};
    const Vec3 m = normalize(wo + wi);
    const double mirror = fresnel_dielectric(dot(wo, m), coat_->eta()).reflectance * coat_->facets().d(m) *
                          coat_->facets().g2(wo, wi, m) / (4 * wo.z);
    return specular_reflectance * mirror + base_ * (coat_->at(wo.z) * coat_->at(wi.z) * cosine_hemisphere_pdf(wi));
}

double RoughPlastic::pdf(Vec3 wo, Vec3 wi) const {
    if (!(wo.z > 0 && wi.z > 0)) return 0;
    const Vec3 m = normalize(wo + wi);
    const double probability = coat_probability(wo.z);
    return probability * coat_->facets().visible_pdf(wo, m) / (4 * dot(wo, m)) +
           (1 - probability) * cosine_hemisphere_pdf(wi);
}

std::optional<BsdfSample> RoughPlastic::sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const {
    if (!(wo.z > 0)) return {};
    const bool from_coat = u[0] < coat_probability(wo.z);
    const Vec3 wi = from_coat ? mirrored(wo, coat_->facets().sample_visible(wo, {u[1], u[2]}))
                              : sample_cosine_hemisphere({u[1], u[2]});
    const double density = pdf(wo, wi);
    if (!(density > 0)) return {};
    return BsdfSample{wi, eval(wo, wi, transport) / density,      density, Measure::solid_angle,
                      1,  from_coat ? coat_->facets().alpha : 1.0};
}

}  // namespace plumb
