#include "scenes/bsdfs/plastic.h"

#include <fmt/format.h>

#include "estimators/densities/warps.h"
#include "scenes/bsdfs/bsdf.h"

namespace plumb {

Spectrum interreflected(const Spectrum& reflectance, double returned, bool nonlinear) {
    Spectrum result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = reflectance[i] / (1 - (nonlinear ? reflectance[i] : 1) * returned);
    return result;
}

Plastic::Plastic(const Spectrum& diffuse, const SmoothCoat& coat, bool nonlinear)
    : diffuse_reflectance(diffuse),
      eta(coat.eta),
      base_(interreflected(diffuse, coat.returned, nonlinear) / (coat.eta * coat.eta)),
      mirror_share_(1 / (1 + largest(diffuse))) {}

double Plastic::mirror_probability(double cos_o) const {
    const double reflectance = fresnel_dielectric(cos_o, eta).reflectance;
    const double mirror = reflectance * mirror_share_, base = (1 - reflectance) * (1 - mirror_share_);
    return mirror / (mirror + base);
}

// Light enters and leaves through the coat: (1 − F(wo)) (1 − F(wi)) on its way to the base and back.
Spectrum Plastic::eval(Vec3 wo, Vec3 wi, Transport) const {
    if (!(wo.z > 0 && wi.z > 0)) return {};
    const double passed =
        (1 - fresnel_dielectric(wo.z, eta).reflectance) * (1 - fresnel_dielectric(wi.z, eta).reflectance);
    return base_ * (passed * cosine_hemisphere_pdf(wi));
}

double Plastic::pdf(Vec3 wo, Vec3 wi) const {
    return wo.z > 0 && wi.z > 0 ? (1 - mirror_probability(wo.z)) * cosine_hemisphere_pdf(wi) : 0;
}

std::optional<BsdfSample> Plastic::sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const {
    if (!(wo.z > 0)) return {};
    const double probability = mirror_probability(wo.z);
    if (u[0] < probability) {
        const double weight = fresnel_dielectric(wo.z, eta).reflectance / probability;
        return BsdfSample{mirrored(wo), specular_reflectance * weight, probability, Measure::discrete, 1, 0};
    }
    const Vec3 wi = sample_cosine_hemisphere({u[1], u[2]});
    const double density = pdf(wo, wi);
    if (!(density > 0)) return {};
    return BsdfSample{wi, eval(wo, wi, transport) / density, density, Measure::solid_angle, 1, 1};
}

namespace description {

Plastic Plastic::load(Properties& properties) {
    Plastic plastic{.eta = properties.index("int_ior", "polypropylene") / properties.index("ext_ior", "air"),
                    .diffuse_reflectance = properties.reflectance("diffuse_reflectance", Spectrum::grey(0.5)),
                    .specular_reflectance = properties.reflectance("specular_reflectance", Spectrum::grey(1)),
                    .nonlinear = properties.boolean("nonlinear", false),
                    .roughness = {}};
    if (properties.type() == "roughplastic") plastic.roughness = Roughness::load(properties);
    return plastic;
}

void Plastic::check(const std::vector<Material>&) const {
    if (!(eta > 1)) throw Error(fmt::format("int_ior over ext_ior is {}; a plastic's coat is above 1", eta));
}

PreparedPlastic Plastic::prepared() const {
    return PreparedPlastic(*this);
}

}  // namespace description

PreparedPlastic::PreparedPlastic(const description::Plastic& plastic)
    : plastic_(plastic), coat_(SmoothCoat(plastic.eta)) {
    if (plastic.roughness) coat_ = std::make_shared<const RoughTransmittance>(plastic.roughness->facets(), plastic.eta);
}

Bsdf PreparedPlastic::at(const Lookup& lookup) const {
    const auto tinted = [&](auto closure) {
        closure.specular_reflectance = lookup.colour(plastic_.specular_reflectance);
        return Bsdf{closure};
    };
    const Spectrum base = lookup.colour(plastic_.diffuse_reflectance);
    if (const auto* smooth = std::get_if<SmoothCoat>(&coat_)) return tinted(Plastic(base, *smooth, plastic_.nonlinear));
    return tinted(RoughPlastic(base, **std::get_if<1>(&coat_), plastic_.nonlinear));
}

}  // namespace plumb
