#include "scenes/textures/texels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "core/images/image.h"
#include "core/images/layers.h"
#include "core/srgb.h"

namespace plumb {

namespace {

// What a number of the file is as an amount of light.
std::function<float(float)> light_of(const Image& image, const std::filesystem::path& file, bool raw) {
    const auto& [name, gamma] = image.encoding;
    const auto as_it_stands = [](float value) { return value; };
    if (raw || (name.empty() && !image.of_integers) || name == "Linear" || name == "linear") return as_it_stands;
    if (gamma > 0) return [gamma](float value) { return static_cast<float>(std::pow(value, gamma)); };
    if (name.empty() || name == "sRGB" || name == "Rec709") return linear_from_srgb<float>;
    throw Error(
        fmt::format("{}: its colours are encoded as '{}'; accepted are linear ones, sRGB, Rec709 and powers, and any "
                    "as raw numbers",
                    file.string(), name));
}

// The channels of red, green and blue: of a file without names for colours, the first for all.
std::array<std::size_t, 3> rgb_of(const Image& image, const std::filesystem::path& file) {
    if (image.channels.size() <= 2) return {0, 0, 0};  // grey, and alpha, by whatever names
    const std::vector<std::string> colours = colours_of(image);
    if (colours.front() == "X")
        throw Error(
            fmt::format("{}: has channels X, Y and Z; accepted for a texture are R, G and B, or Y", file.string()));
    std::array<std::size_t, 3> found;
    for (std::size_t c = 0; c < 3; ++c)
        found[c] = static_cast<std::size_t>(
            std::ranges::find(image.channels, colours[std::min(c, colours.size() - 1)]) - image.channels.begin());
    return found;
}

Image read_colours(const std::filesystem::path& file) {
    Image image = read_image(file);
    return image.channels.size() <= 2 ? image : picture_layer(std::move(image), file);
}

}  // namespace

Texels read_texels(const std::filesystem::path& file, bool raw) {
    const Image image = read_colours(file);
    require_finite(image, file);
    const std::size_t channels = image.channels.size();
    const auto light = light_of(image, file, raw);
    const std::array<std::size_t, 3> rgb = rgb_of(image, file);
    Texels texels{image.width, image.height, {}};
    texels.rgb.reserve(image.values.size() / channels * 3);
    for (std::size_t at = 0; at < image.values.size(); at += channels) {
        for (const std::size_t channel : rgb) {
            const float value = image.values[at + channel];
            if (value < 0) {
                throw Error(
                    fmt::format("{}: texel {} is {}; accepted are values from 0", file.string(), at / channels, value));
            }
            texels.rgb.push_back(light(value));
        }
    }
    return texels;
}

}  // namespace plumb
