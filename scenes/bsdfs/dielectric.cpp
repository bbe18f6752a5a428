#include "scenes/bsdfs/dielectric.h"

#include "scenes/bsdfs/bsdf.h"
#include "scenes/bsdfs/fresnel.h"

namespace plumb {

std::optional<BsdfSample> Dielectric::sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const {
    if (wo.z == 0) return {};
    const double across = wo.z > 0 ? eta : 1 / eta;
    const auto [chance, cos_t] = fresnel_dielectric(std::abs(wo.z), across);
    if (u[0] < chance) return BsdfSample{mirrored(wo), reflectance, chance, Measure::discrete, 1, 0};
    const Vec3 wi{-wo.x / across, -wo.y / across, -std::copysign(cos_t, wo.z)};
    const double weight = transport == Transport::radiance ? 1 / (across * across) : 1;
    return BsdfSample{wi, transmittance * weight, 1 - chance, Measure::discrete, across, 0};
}

namespace description {

Dielectric Dielectric::load(Properties& properties) {
    Dielectric dielectric{.eta = properties.index("int_ior", "bk7") / properties.index("ext_ior", "air"),
                          .specular_reflectance = properties.reflectance("specular_reflectance", Spectrum::grey(1)),
                          .specular_transmittance = properties.reflectance("specular_transmittance", Spectrum::grey(1)),
                          .roughness = {}};
    if (properties.type() == "roughdielectric") dielectric.roughness = Roughness::load(properties);
    return dielectric;
}

Bsdf Dielectric::at(const Lookup& lookup) const {
    const Spectrum reflectance = lookup.colour(specular_reflectance);
    const Spectrum transmittance = lookup.colour(specular_transmittance);
    // Without contrast a rough interface scatters nothing: it lets light through as a smooth one does.
    if (roughness && eta != 1) return {RoughDielectric{roughness->facets(), eta, reflectance, transmittance}};
    return {plumb::Dielectric{eta, reflectance, transmittance}};
}

}  // namespace description

}  // namespace plumb
