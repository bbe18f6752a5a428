#include "scenes/bsdfs/conductor.h"

#include "scenes/bsdfs/fresnel.h"

namespace plumb {

std::optional<BsdfSample> Conductor::sample(Vec3 wo, const std::array<double, 3>&, Transport) const {
    if (!(wo.z > 0)) return {};
    return BsdfSample{mirrored(wo), reflectance * fresnel_conductor(wo.z, eta, k), 1, Measure::discrete, 1, 0};
}

}  // namespace plumb
