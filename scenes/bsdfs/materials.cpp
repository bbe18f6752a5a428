#include "scenes/bsdfs/materials.h"

#include <fmt/format.h>

namespace plumb {

using description::MaterialId;

namespace {

Microfacets facets(const description::Roughness& roughness) {
    const bool ggx = roughness.distribution == description::Microfacets::ggx;
    return {ggx ? MicrofacetShape::ggx : MicrofacetShape::beckmann, roughness.alpha};
}

using Kind = decltype(description::Material::kind);

void check(const description::Material& material, const std::vector<description::Material>& all) {
    if (const auto* plastic = std::get_if<description::Plastic>(&material.kind); plastic && !(plastic->eta > 1))
        throw material.place.error(
            fmt::format("int_ior over ext_ior is {}; a plastic's coat is above 1", plastic->eta));
    const auto* sides = std::get_if<description::TwoSided>(&material.kind);
    if (!sides) return;
    for (const MaterialId side : {sides->front, sides->back}) {
        const Kind& kind = all[side.index].kind;
        if (std::holds_alternative<description::Dielectric>(kind) || std::holds_alternative<description::Mask>(kind) ||
            std::holds_alternative<description::TwoSided>(kind))
            throw material.place.error(
                "'twosided' around a dielectric, a mask or another 'twosided'; accepted are bsdfs that only reflect");
    }
}

}  // namespace

Materials::Materials(const description::Scene& scene)
    : materials_(scene.materials),
      textures_(texture_lookups(scene)),
      smooth_coats_(materials_.size()),
      rough_coats_(materials_.size()) {
    for (std::size_t i = 0; i < materials_.size(); ++i) {
        check(materials_[i], materials_);
        const auto* plastic = std::get_if<description::Plastic>(&materials_[i].kind);
        if (!plastic) continue;
        if (plastic->roughness)
            rough_coats_[i].emplace(facets(*plastic->roughness), plastic->eta);
        else
            smooth_coats_[i].emplace(plastic->eta);
    }
}

Bsdf Materials::at(MaterialId material, const std::array<double, 2>& uv, bool outside) const {
    const Where where{material, uv, outside};
    return std::visit([&](const auto& kind) { return resolved(kind, where); }, materials_[material.index].kind);
}

double Materials::opacity(MaterialId id, const std::array<double, 2>& uv) const {
    const auto* mask = std::get_if<description::Mask>(&materials_[id.index].kind);
    return mask ? std::clamp(luminance(colour(mask->opacity, uv)), 0.0, 1.0) : 1;
}

bool Materials::is_mask(MaterialId id) const {
    return std::holds_alternative<description::Mask>(materials_[id.index].kind);
}

Bsdf Materials::resolved(const description::Diffuse& diffuse, const Where& at) const {
    return {Diffuse{colour(diffuse.reflectance, at.uv)}};
}

Bsdf Materials::resolved(const description::Conductor& conductor, const Where& at) const {
    const Spectrum reflectance = colour(conductor.specular_reflectance, at.uv);
    const Spectrum eta = conductor.eta.value_or(Spectrum{}), k = conductor.eta ? conductor.k : Spectrum::grey(1);
    if (conductor.roughness) return {RoughConductor{facets(*conductor.roughness), eta, k, reflectance}};
    return {Conductor{eta, k, reflectance}};
}

Bsdf Materials::resolved(const description::Dielectric& dielectric, const Where& at) const {
    const Spectrum reflectance = colour(dielectric.specular_reflectance, at.uv);
    const Spectrum transmittance = colour(dielectric.specular_transmittance, at.uv);
    // Without contrast a rough interface scatters nothing: it lets light through as a smooth one does.
    if (dielectric.roughness && dielectric.eta != 1)
        return {RoughDielectric{facets(*dielectric.roughness), dielectric.eta, reflectance, transmittance}};
    return {Dielectric{dielectric.eta, reflectance, transmittance}};
}

Bsdf Materials::resolved(const description::Plastic& plastic, const Where& at) const {
    const auto tinted = [&](auto closure) {
        closure.specular_reflectance = colour(plastic.specular_reflectance, at.uv);
        return Bsdf{closure};
    };
    const Spectrum base = colour(plastic.diffuse_reflectance, at.uv);
    if (const auto& coat = rough_coats_[at.material.index]) return tinted(RoughPlastic(base, *coat, plastic.nonlinear));
    return tinted(Plastic(base, *smooth_coats_[at.material.index], plastic.nonlinear));
}

Bsdf Materials::resolved(const description::TwoSided& sides, const Where& at) const {
    Bsdf bsdf = this->at(at.outside ? sides.front : sides.back, at.uv, true);
    bsdf.two_sided = true;
    return bsdf;
}

Bsdf Materials::resolved(const description::Mask& mask, const Where& at) const {
    return this->at(mask.nested, at.uv, at.outside);
}

}  // namespace plumb
