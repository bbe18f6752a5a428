#include "scenes/bsdfs/materials.h"

namespace plumb {

using description::MaterialId;

namespace {

void check(const description::Material& material, const std::vector<description::Material>& all) {
    const auto check_kind = [&](const auto& kind) {
        if constexpr (requires { kind.check(all); }) kind.check(all);
    };
    try {
        std::visit(check_kind, material.kind);
    } catch (const Error& error) {
        throw material.place.error(error.what());
    }
}

template <class Model>
constexpr bool lets_pass(const Model&) {
    return requires(const Model& model, const Lookup& lookup) {
        model.opacity_at(lookup);
    };
}

}  // namespace

Materials::Materials(const std::vector<description::Material>& materials,
                     const std::vector<description::Texture>& textures)
    : textures_(textures.begin(), textures.end()) {
    materials_.reserve(materials.size());
    for (const description::Material& material : materials) {
        check(material, materials);
        materials_.push_back(prepared(material.kind));
    }
}

Bsdf Materials::at(MaterialId material, const std::array<double, 2>& uv, bool outside) const {
    const Lookup lookup{*this, textures_, uv, outside};
    return std::visit([&](const auto& model) { return model.at(lookup); }, materials_[material.index]);
}

double Materials::opacity(MaterialId material, const std::array<double, 2>& uv) const {
    const Lookup lookup{*this, textures_, uv, true};
    const auto opacity_of = [&](const auto& model) {
        if constexpr (requires { model.opacity_at(lookup); })
            return model.opacity_at(lookup);
        else
            return 1.0;
    };
    return std::visit(opacity_of, materials_[material.index]);
}

bool Materials::is_mask(MaterialId material) const {
    return std::visit([](const auto& model) { return lets_pass(model); }, materials_[material.index]);
}

Bsdf Lookup::nested(MaterialId material, bool from_outside) const {
    return materials.at(material, uv, from_outside);
}

}  // namespace plumb
