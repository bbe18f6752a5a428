#include "scenes/textures/bitmap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace plumb {

namespace {

int wrapped(std::int64_t i, int size, description::Wrap wrap) {
    if (wrap == description::Wrap::clamp) return static_cast<int>(std::clamp<std::int64_t>(i, 0, size - 1));
    const std::int64_t period = wrap == description::Wrap::mirror ? 2 * static_cast<std::int64_t>(size) : size;
    const std::int64_t in_period = (i % period + period) % period;
    return static_cast<int>(in_period < size ? in_period : period - 1 - in_period);
}

/// The texel at or before a coordinate in [0, 1) of the texture, and how far on the way to the next.
std::pair<std::int64_t, double> texel_before(double coordinate, int size) {
    // Reduced by whole mirror periods first: far from the origin, an index must still fit into an integer.
    const double reduced = std::abs(coordinate) < 1e6 ? coordinate : std::remainder(coordinate, 2.0);
    const double x = reduced * size - 0.5, below = std::floor(x);
    return {static_cast<std::int64_t>(below), x - below};
}

}  // namespace

Spectrum bilinear(const Texels& texels, description::Wrap wrap, double u, double v) {
    const auto [x, s] = texel_before(u, texels.width);
    const auto [y, t] = texel_before(v, texels.height);
    const int x0 = wrapped(x, texels.width, wrap), x1 = wrapped(x + 1, texels.width, wrap);
    const int y0 = wrapped(y, texels.height, wrap), y1 = wrapped(y + 1, texels.height, wrap);
    return (texels.texel(x0, y0) * (1 - s) + texels.texel(x1, y0) * s) * (1 - t) +
           (texels.texel(x0, y1) * (1 - s) + texels.texel(x1, y1) * s) * t;
}

namespace description {

Bitmap Bitmap::load(Properties& properties) {
    Bitmap bitmap{.file = properties.file("filename"), .raw = properties.boolean("raw", false)};
    // 0.6 gives a gamma instead: 1 means linear, -1 (as the file says) is what we do anyway.
    const double gamma = properties.number("gamma", -1);
    if (properties.has("gamma") && properties.has("raw"))
        throw properties.place_of("gamma").error("gamma is given, and raw too; one of them is accepted");
    if (gamma == 1) bitmap.raw = true;
    if (gamma != 1 && gamma != -1) properties.ignored(fmt::format("gamma {} of bitmap; sRGB is taken", gamma));
    if (const std::string filter = properties.string("filter_type", "bilinear"); filter != "bilinear") {
        properties.ignored(fmt::format("filter_type '{}' of bitmap; bilinear is taken", filter));
    }
    const std::string wrap = properties.string("wrap_mode", "repeat");
    if (wrap == "mirror")
        bitmap.wrap = Wrap::mirror;
    else if (wrap == "clamp")
        bitmap.wrap = Wrap::clamp;
    else if (wrap != "repeat")
        throw properties.place().error(unknown_name("wrap_mode", wrap, {"repeat", "mirror", "clamp"}).what());
    return bitmap;
}

BitmapLookup Bitmap::prepared() const {
    return {std::make_shared<const Texels>(read_texels(file, raw)), wrap};
}

}  // namespace description

}  // namespace plumb
