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

double roughness(const Diffuse&) {
    return 1;
}
double roughness(const Plastic&) {
    return 1;
}
double roughness(const Conductor&) {
    return 0;
}
double roughness(const Dielectric&) {
    return 0;
}
double roughness(const RoughConductor& bsdf) {
    return bsdf.facets.alpha;
}
double roughness(const RoughDielectric& bsdf) {
    return bsdf.facets.alpha;
}
double roughness(const RoughPlastic& bsdf) {
    return bsdf.roughness();
}

}  // namespace

Spectrum albedo(const Bsdf& bsdf) {
    return std::visit([](const auto& model) { return colour(model); }, bsdf.model);
}

double smooth_roughness(const Bsdf& bsdf) {
    return std::visit([](const auto& model) { return roughness(model); }, bsdf.model);
}

double eta_between(const Bsdf& bsdf, Vec3 wo, Vec3 wi) {
    const auto* glass = std::get_if<RoughDielectric>(&bsdf.model);
    if (!glass || same_side(wo, wi)) return 1;
    return wo.z > 0 ? glass->eta : 1 / glass->eta;
}

}  // namespace plumb
