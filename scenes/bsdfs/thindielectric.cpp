#include "scenes/bsdfs/thindielectric.h"

#include "scenes/bsdfs/bsdf.h"
#include "scenes/bsdfs/fresnel.h"

namespace plumb {

// An interface reflects R of what comes, from inside as from outside, since the angles are each other's refraction.
// The sum over all reflections within, R + (1 − R)² R (1 + R² + R⁴ + …), is 2R/(1 + R).
double pane_reflectance(double cos_i, double eta) {
    const double once = fresnel_dielectric(cos_i, eta).reflectance;
    return 2 * once / (1 + once);
}

std::optional<BsdfSample> ThinDielectric::sample(Vec3 wo, const std::array<double, 3>& u, Transport) const {
    if (wo.z == 0) return {};
    const double chance = pane_reflectance(std::abs(wo.z), eta);
    if (u[0] < chance) return BsdfSample{mirrored(wo), reflectance, chance, Measure::discrete, 1, 0};
    return BsdfSample{-wo, transmittance, 1 - chance, Measure::discrete, 1, 0};
}

namespace description {

ThinDielectric ThinDielectric::load(Properties& properties) {
    return {.eta = properties.index("int_ior", "bk7") / properties.index("ext_ior", "air"),
            .specular_reflectance = properties.reflectance("specular_reflectance", Spectrum::grey(1)),
            .specular_transmittance = properties.reflectance("specular_transmittance", Spectrum::grey(1))};
}

Bsdf ThinDielectric::at(const Lookup& lookup) const {
    return {plumb::ThinDielectric{eta, lookup.colour(specular_reflectance), lookup.colour(specular_transmittance)}};
}

}  // namespace description

}  // namespace plumb
