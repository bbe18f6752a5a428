#include "scenes/bsdfs/dielectric.h"

#include "scenes/bsdfs/fresnel.h"

namespace plumb {

std::optional<BsdfSample> Dielectric::sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const {
    if (wo.z == 0) return {};
    const double across = wo.z > 0 ? eta : 1 / eta;
    const auto [reflectance, cos_t] = fresnel_dielectric(std::abs(wo.z), across);
    if (u[0] < reflectance) return BsdfSample{mirrored(wo), Spectrum::grey(1), reflectance, Measure::discrete, 1, 0};
    const Vec3 wi{-wo.x / across, -wo.y / across, -std::copysign(cos_t, wo.z)};
    const double weight = transport == Transport::radiance ? 1 / (across * across) : 1;
    return BsdfSample{wi, Spectrum::grey(weight), 1 - reflectance, Measure::discrete, across, 0};
}

}  // namespace plumb
