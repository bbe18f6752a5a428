#include "scenes/textures/texture.h"

namespace plumb {

namespace {

auto prepared_at_place(const description::Texture& texture) {
    try {
        return prepared(texture.kind);
    } catch (const Error& error) {
        throw texture.place.error(error.what());
    }
}

}  // namespace

TextureLookup::TextureLookup(const description::Texture& texture)
    : model_(prepared_at_place(texture)), to_uv_(texture.to_uv) {}

Spectrum TextureLookup::at(double u, double v) const {
    const Vec3 uv = to_uv_.point({u, v, 0});
    return std::visit([&](const auto& model) { return model.at(uv.x, uv.y); }, model_);
}

Spectrum value(const description::Colour& colour, const std::vector<TextureLookup>& textures, double u, double v) {
    if (const auto* constant = std::get_if<Spectrum>(&colour)) return *constant;
    return textures[std::get<description::TextureId>(colour).index].at(u, v);
}

}  // namespace plumb
