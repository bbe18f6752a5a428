#include "scenes/bsdfs/lunar.h"

#include "estimators/densities/warps.h"
#include "scenes/bsdfs/bsdf.h"

namespace plumb {

Spectrum Lunar::eval(Vec3 wo, Vec3 wi, Transport) const {
    if (!(wo.z > 0 && wi.z > 0)) return {};
    return grain * (wi.z / (4 * pi * (wi.z + wo.z)));
}

// Uniform on the hemisphere: the weight w/2 · μi/(μi + μo) is bounded then.
double Lunar::pdf(Vec3 wo, Vec3 wi) const {
    return wo.z > 0 && wi.z > 0 ? 1 / (2 * pi) : 0;
}

std::optional<BsdfSample> Lunar::sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const {
    if (!(wo.z > 0)) return {};
    const Vec3 wi = sample_uniform_cone({u[1], u[2]}, 1);
    const double density = pdf(wo, wi);
    if (!(density > 0)) return {};
    return BsdfSample{wi, eval(wo, wi, transport) / density, density, Measure::solid_angle, 1, 1};
}

namespace description {

Lunar Lunar::load(Properties& properties) {
    return {properties.reflectance("grain", Spectrum::grey(0.5))};
}

Bsdf Lunar::at(const Lookup& lookup) const {
    return {plumb::Lunar{lookup.colour(grain)}};
}

}  // namespace description

}  // namespace plumb
