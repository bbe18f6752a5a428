#include "scenes/bsdfs/diffuse.h"

#include "estimators/densities/warps.h"
#include "scenes/bsdfs/bsdf.h"

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

namespace description {

Diffuse Diffuse::load(Properties& properties) {
    // 0.4 wrote diffuse_reflectance.
    const auto old = properties.reflectance("diffuse_reflectance", Spectrum::grey(0.5));
    const auto reflectance = properties.reflectance("reflectance", Spectrum::grey(0.5));
    if (properties.has("diffuse_reflectance") && properties.has("reflectance"))
        throw properties.place_of("diffuse_reflectance")
            .error("reflectance is given, and diffuse_reflectance too; one of them is accepted");
    return {properties.has("diffuse_reflectance") ? old : reflectance};
}

Bsdf Diffuse::at(const Lookup& lookup) const {
    return {plumb::Diffuse{lookup.colour(reflectance)}};
}

}  // namespace description

}  // namespace plumb
