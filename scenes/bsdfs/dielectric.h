#pragma once

#include "scenes/bsdfs/bsdf_model.h"

namespace plumb {

/// A smooth interface between two media. Fresnel's reflectance is the probability of the mirrored direction.
struct Dielectric {
    double eta = 1.5;                                                             ///< index inside over index outside
    Spectrum reflectance = Spectrum::grey(1), transmittance = Spectrum::grey(1);  ///< factors of no physics

    [[nodiscard]] Spectrum eval(Vec3, Vec3, Transport) const { return {}; }
    [[nodiscard]] double pdf(Vec3, Vec3) const { return 0; }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const;
    [[nodiscard]] double discrete(Vec3 wo) const { return wo.z != 0 ? 1 : 0; }
};

static_assert(BsdfModel<Dielectric>);

}  // namespace plumb
