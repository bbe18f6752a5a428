#include "scenes/bsdfs/diffuse.h"

#include "estimators/densities/warps.h"

namespace plumb {

Spectrum Diffuse::eval(Vec3 wo, Vec3 wi, Transport) const {
    return reflectance * pdf(wo, wi);
}

double Diffuse::pdf(Vec3 wo, Vec3 wi) const {
    return wo.z > 0 ? cosine_hemisphere_pdf(wi) : 0;
}

std::optional<BsdfSample> Diffuse::sample(Vec3 wo, const std::array<double, 3>& u, Transport) const {
    if (!(wo.z > 0)) return {};
    const Vec3 wi = sample_cosine_hemisphere({u[1], u[2]});
    return BsdfSample{wi, reflectance, cosine_hemisphere_pdf(wi), Measure::solid_angle, 1, 1};
}

}  // namespace plumb
