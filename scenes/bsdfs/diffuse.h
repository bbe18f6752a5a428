#pragma once

#include "scenes/bsdfs/bsdf_model.h"

namespace plumb {

/// Lambert's surface: reflects above, black below.
struct Diffuse {
    Spectrum reflectance = Spectrum::grey(0.5);

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport) const;
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport) const;
    [[nodiscard]] double discrete(Vec3) const { return 0; }
};

static_assert(BsdfModel<Diffuse>);

}  // namespace plumb
