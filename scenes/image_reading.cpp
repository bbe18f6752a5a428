#include <cmath>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "scenes/texture.h"

namespace plumb {

namespace {

float linear_from_srgb(float s) {
    return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);  // [IEC 61966-2-1]
}

}  // namespace

Image read_image(const std::filesystem::path& file, bool raw) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) throw Error(fmt::format("cannot decode {}: {}", file.string(), OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1) {
        throw Error(fmt::format("{} is an image of {}×{}×{} texels of {} channels", file.string(), spec.width,
                                spec.height, spec.depth, spec.nchannels));
    }
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<float> texels(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * channels);
    const bool decode = !raw && !spec.format.is_floating_point();
    const int width = spec.width, height = spec.height;
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, texels.data())) {
        throw Error(fmt::format("cannot decode {}: {}", file.string(), input->geterror()));
    }
    Image image{width, height, {}};
    image.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t at = 0; at < texels.size(); at += channels) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = texels[at + (channels >= 3 ? c : 0)];
            if (!(value >= 0 && std::isfinite(value))) {
                throw Error(fmt::format("{}: texel {} is {}; finite values from 0 are accepted", file.string(),
                                        at / channels, value));
            }
            image.rgb.push_back(decode ? linear_from_srgb(value) : value);
        }
    }
    return image;
}

}  // namespace plumb
