#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using description::Checkerboard;
using description::Texture;
using description::TextureId;

namespace {

/// to_uv of 3, or the four numbers of 0.6, which scale first.
Transform uv_transform(description::Properties& properties) {
    const double scale = properties.number("uvscale", 1);
    const Vec3 by{properties.number("uscale", scale), properties.number("vscale", scale), 1};
    const Vec3 offset{properties.number("uoffset", 0), properties.number("voffset", 0), 0};
    return Transform::translate(offset) * Transform::scale(by) * properties.transform("to_uv");
}

}  // namespace

TextureId load_texture(const XmlElement& element, Loader& loader) {
    if (const auto found = loader.textures.find(&element); found != loader.textures.end()) return found->second;
    if (element.tag != "texture")
        throw element.place.error(fmt::format("<{}> where a <texture> is expected", element.tag));
    XmlProperties properties(element, loader);
    Texture texture{.kind = Checkerboard{}, .to_uv = {}, .place = element.place};
    try {
        texture.to_uv = uv_transform(properties);
    } catch (const Error& error) {
        const std::string message = error.what();
        throw message.starts_with(element.place.file) ? Error(message) : element.place.error(message);
    }
    using Kind = decltype(Texture::kind);
    if (auto kind = load_model<Kind>(description::TextureModels{}, properties)) {
        texture.kind = *std::move(kind);
    } else {
        properties.replaced(fmt::format("texture '{}' by grey", properties.type()), loader.unknown_plugin(element));
        texture.kind = Checkerboard{Spectrum::grey(0.5), Spectrum::grey(0.5)};
        element.reading.left_out = true;
    }
    properties.finish();
    const TextureId id{static_cast<std::uint32_t>(loader.scene.textures.size())};
    loader.scene.textures.push_back(std::move(texture));
    loader.textures[&element] = id;
    return id;
}

}  // namespace plumb::mitsuba
