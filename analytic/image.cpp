#include "analytic/image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

Error unreadable(const std::filesystem::path& file, std::string why) {
    std::ranges::replace(why, '\n', ' ');
    return Error(fmt::format("{}: not a readable image: {}", file.string(), why));
}

void check_layout(const std::filesystem::path& file, const OIIO::ImageSpec& spec) {
    if (spec.deep) throw unreadable(file, "it is a deep image; accepted are images with one value a channel");
    if (spec.width < 1 || spec.height < 1 || spec.depth != 1 || spec.nchannels < 1)
        throw unreadable(file, fmt::format("it has {} × {} × {} pixels of {} channels; accepted are flat images",
                                           spec.width, spec.height, spec.depth, spec.nchannels));
    if (spec.image_pixels() > (std::uint64_t{1} << 30) / static_cast<std::uint64_t>(spec.nchannels))
        throw unreadable(file, fmt::format("{} × {} pixels of {} channels; accepted are 2^30 numbers", spec.width,
                                           spec.height, spec.nchannels));
}

void check_values(const std::filesystem::path& file, const Image& image) {
    const auto bad = std::ranges::find_if(image.values, [](float v) { return !std::isfinite(v); });
    if (bad == image.values.end()) return;
    const auto index = static_cast<std::size_t>(bad - image.values.begin()), channels = image.channels.size();
    const std::size_t pixel = index / channels, width = static_cast<std::size_t>(image.width);
    throw Error(fmt::format("{}: pixel ({}, {}), channel {} is {}; accepted are finite numbers", file.string(),
                            pixel % width, pixel / width, image.channels[index % channels], *bad));
}

}  // namespace

Image read_image(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) throw Error(fmt::format("{}: there is no such file", file.string()));
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) throw unreadable(file, OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    check_layout(file, spec);
    Image image{spec.width, spec.height, spec.channelnames, {}};
    image.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data()))
        throw unreadable(file, input->geterror());
    // some readers fill what is missing and only complain
    if (input->has_error()) throw unreadable(file, input->geterror());
    check_values(file, image);
    return image;
}

bool has_image_extension(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot + 1 == name.size()) return false;
    std::string extension(name.substr(dot + 1));
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    // "openexr:exr,sxr,mxr;tiff:tif,tiff,…"
    std::string known = OIIO::get_string_attribute("extension_list");
    std::ranges::replace_if(known, [](char c) { return c == ':' || c == ';'; }, ',');
    return ("," + known + ",").find("," + extension + ",") != std::string::npos;
}

}  // namespace plumb
