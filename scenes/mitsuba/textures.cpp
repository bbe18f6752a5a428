#include <fmt/format.h>

#include "scenes/mitsuba/loader.h"

namespace plumb::mitsuba {

using namespace description;

namespace {

Bitmap load_bitmap(Properties& properties, Loader& loader) {
    Bitmap bitmap{.file = properties.file("filename"), .raw = properties.boolean("raw", false)};
    // 0.6 gives a gamma instead: 1 means linear, -1 (as the file says) is what we do anyway.
    const double gamma = properties.number("gamma", -1);
    if (gamma == 1) bitmap.raw = true;
    const Place& place = properties.element().place;
    if (gamma != 1 && gamma != -1) loader.ignored(place, fmt::format("gamma {} of bitmap; sRGB is taken", gamma));
    if (const std::string filter = properties.string("filter_type", "bilinear"); filter != "bilinear") {
        loader.ignored(place, fmt::format("filter_type '{}' of bitmap; bilinear is taken", filter));
    }
    const std::string wrap = properties.string("wrap_mode", "repeat");
    if (wrap == "mirror")
        bitmap.wrap = Wrap::mirror;
    else if (wrap == "clamp")
        bitmap.wrap = Wrap::clamp;
    else if (wrap != "repeat")
        throw place.error(unknown_name("wrap_mode", wrap, {"repeat", "mirror", "clamp"}).what());
    return bitmap;
}

/// to_uv of 3, or the four numbers of 0.6, which scale first.
Transform uv_transform(Properties& properties) {
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
    Properties properties(element, loader);
    Texture texture{.kind = Checkerboard{}, .to_uv = {}, .place = element.place};
    try {
        texture.to_uv = uv_transform(properties);
    } catch (const Error& error) {
        const std::string message = error.what();
        throw message.starts_with(element.place.file) ? Error(message) : element.place.error(message);
    }
    const std::string& type = element.attribute("type");
    if (type == "bitmap") {
        texture.kind = load_bitmap(properties, loader);
    } else if (type == "checkerboard") {
        const Checkerboard otherwise;
        texture.kind = Checkerboard{properties.constant_reflectance("color0", otherwise.color0),
                                    properties.constant_reflectance("color1", otherwise.color1)};
    } else {
        loader.replaced(element.place, fmt::format("texture '{}' by grey", type), loader.unknown_plugin(element));
        texture.kind = Checkerboard{Spectrum::grey(0.5), Spectrum::grey(0.5)};
    }
    properties.finish();
    const TextureId id{static_cast<std::uint32_t>(loader.scene.textures.size())};
    loader.scene.textures.push_back(std::move(texture));
    loader.textures[&element] = id;
    return id;
}

}  // namespace plumb::mitsuba
