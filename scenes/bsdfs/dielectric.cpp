#include "scenes/bsdfs/dielectric.h"

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

}  // namespace plumb
