#pragma once

#include "scenes/bsdfs/bsdf_model.h"

namespace plumb {

/// A smooth metal of index eta + i k relative to the outside: a mirror above, black below. eta = 0 reflects everything.
struct Conductor {
    Spectrum eta, k = Spectrum::grey(1);
    Spectrum reflectance = Spectrum::grey(1);  ///< a factor of no physics, which scene files use

    [[nodiscard]] Spectrum eval(Vec3, Vec3, Transport) const { return {}; }
    [[nodiscard]] double pdf(Vec3, Vec3) const { return 0; }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport) const;
    [[nodiscard]] double discrete(Vec3 wo) const { return wo.z > 0 ? 1 : 0; }
};

static_assert(BsdfModel<Conductor>);

}  // namespace plumb
