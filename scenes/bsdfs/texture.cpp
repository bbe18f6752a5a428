#include "scenes/bsdfs/texture.h"

#include <cmath>

#include "core/image.h"
#include "core/srgb.h"

namespace plumb {

using description::Checkerboard;
using description::Wrap;

namespace {

int wrapped(std::int64_t i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp) return static_cast<int>(std::clamp<std::int64_t>(i, 0, size - 1));
    const std::int64_t period = wrap == Wrap::mirror ? 2 * static_cast<std::int64_t>(size) : size;
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

Texels read_texels(const std::filesystem::path& file, bool raw) {
    const Image image = read_image(file);
    require_finite(image, file);
    const std::size_t channels = image.channels.size();
    Texels texels{image.width, image.height, {}};
    texels.rgb.reserve(image.values.size() / channels * 3);
    for (std::size_t at = 0; at < image.values.size(); at += channels) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = image.values[at + (channels >= 3 ? c : 0)];
            if (value < 0) {
                throw Error(
                    fmt::format("{}: texel {} is {}; accepted are values from 0", file.string(), at / channels, value));
            }
            texels.rgb.push_back(image.of_integers && !raw ? linear_from_srgb(value) : value);
        }
    }
    return texels;
}

Spectrum bilinear(const Texels& texels, Wrap wrap, double u, double v) {
    const auto [x, s] = texel_before(u, texels.width);
    const auto [y, t] = texel_before(v, texels.height);
    const int x0 = wrapped(x, texels.width, wrap), x1 = wrapped(x + 1, texels.width, wrap);
    const int y0 = wrapped(y, texels.height, wrap), y1 = wrapped(y + 1, texels.height, wrap);
    return (texels.texel(x0, y0) * (1 - s) + texels.texel(x1, y0) * s) * (1 - t) +
           (texels.texel(x0, y1) * (1 - s) + texels.texel(x1, y1) * s) * t;
}

TextureLookup::TextureLookup(const description::Texture& texture) : kind_(Checkerboard{}), to_uv_(texture.to_uv) {
    if (const auto* board = std::get_if<Checkerboard>(&texture.kind)) {
        kind_ = *board;
        return;
    }
    const auto& bitmap = std::get<description::Bitmap>(texture.kind);
    try {
        kind_ = Picture{std::make_shared<const Texels>(read_texels(bitmap.file, bitmap.raw)), bitmap.wrap};
    } catch (const Error& error) {
        throw texture.place.error(error.what());
    }
}

Spectrum TextureLookup::at(double u, double v) const {
    const Vec3 uv = to_uv_.point({u, v, 0});
    if (const auto* picture = std::get_if<Picture>(&kind_))
        return bilinear(*picture->texels, picture->wrap, uv.x, uv.y);
    const auto& board = std::get<Checkerboard>(kind_);
    const bool right = uv.x - std::floor(uv.x) >= 0.5, low = uv.y - std::floor(uv.y) >= 0.5;
    return right == low ? board.color0 : board.color1;
}

std::vector<TextureLookup> texture_lookups(const description::Scene& scene) {
    return {scene.textures.begin(), scene.textures.end()};
}

Spectrum value(const description::Colour& colour, const std::vector<TextureLookup>& textures, double u, double v) {
    if (const auto* constant = std::get_if<Spectrum>(&colour)) return *constant;
    return textures[std::get<description::TextureId>(colour).index].at(u, v);
}

}  // namespace plumb
