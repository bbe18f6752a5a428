#include "scenes/bsdfs/bsdf.h"

#include "scenes/bsdfs/fresnel.h"

namespace plumb {

namespace {

Spectrum colour(const Diffuse& bsdf) {
    return bsdf.reflectance;
}
/// Of a metal: what it reflects at normal incidence.
template <class Metal>
requires requires(const Metal& metal) {
    metal.k;
}
Spectrum colour(const Metal& metal) {
    return metal.reflectance * fresnel_conductor(1, metal.eta, metal.k);
}
Spectrum colour(const Dielectric&) {
    return Spectrum::grey(1);
}
Spectrum colour(const RoughDielectric&) {
    return Spectrum::grey(1);
}
Spectrum colour(const Plastic& bsdf) {
    return bsdf.diffuse_reflectance;
}
Spectrum colour(const RoughPlastic& bsdf) {
    return bsdf.diffuse_reflectance;
}

}  // namespace

Spectrum albedo(const Bsdf& bsdf) {
    return std::visit([](const auto& model) { return colour(model); }, bsdf.model);
}

}  // namespace plumb
