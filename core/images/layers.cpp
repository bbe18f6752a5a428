#include "core/images/layers.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/error.h"

namespace plumb {
namespace {

bool has(const Image& image, const std::string& channel) {
    return std::ranges::find(image.channels, channel) != image.channels.end();
}

// The channels of a layer, by the names that they have within it.
Image only(const Image& image, const std::string& layer) {
    const std::string prefix = layer + ".";
    std::vector<std::size_t> kept;
    for (std::size_t c = 0; c < image.channels.size(); ++c)
        if (image.channels[c].starts_with(prefix)) kept.push_back(c);
    Image part{image.width, image.height, {}, {}, image.metadata, image.of_integers, image.encoding};
    for (const std::size_t c : kept) part.channels.push_back(image.channels[c].substr(prefix.size()));
    part.values.reserve(image.values.size() / image.channels.size() * kept.size());
    for (std::size_t pixel = 0; pixel < image.values.size(); pixel += image.channels.size())
        for (const std::size_t c : kept) part.values.push_back(image.values[pixel + c]);
    return part;
}

[[noreturn]] void refuse(const Image& image, const std::filesystem::path& file, const std::string& what) {
    const std::vector<std::string> layers = coloured_layers(image);
    throw Error(fmt::format("{}: {}; its channels are {}; accepted are R, G and B, or X, Y and Z, or Y{}",
                            file.string(), what, fmt::join(image.channels, ", "),
                            layers.empty() ? "" : fmt::format(", of one layer: {}", fmt::join(layers, ", "))));
}

}  // namespace

std::vector<std::string> colours_of(const Image& image) {
    if (has(image, "C") && has(image, "M") && has(image, "K")) return {};
    for (const std::vector<std::string>& set : {std::vector<std::string>{"R", "G", "B"}, {"X", "Y", "Z"}, {"Y"}})
        if (std::ranges::all_of(set, [&](const std::string& c) { return has(image, c); })) return set;
    return {};
}

std::vector<std::string> coloured_layers(const Image& image) {
    std::set<std::string> names;
    for (const std::string& channel : image.channels)
        if (const std::size_t dot = channel.rfind('.'); dot != std::string::npos) names.insert(channel.substr(0, dot));
    std::vector<std::string> coloured;
    const Image layout{0, 0, image.channels, {}};
    for (const std::string& name : names)
        if (!colours_of(only(layout, name)).empty()) coloured.push_back(name);
    return coloured;
}

Image picture_layer(Image image, const std::filesystem::path& file, const std::string& layer) {
    if (!layer.empty()) {
        Image part = only(image, layer);
        if (colours_of(part).empty()) refuse(image, file, fmt::format("has no colours in a layer '{}'", layer));
        return part;
    }
    if (!colours_of(image).empty()) return image;
    const std::vector<std::string> layers = coloured_layers(image);
    if (layers.empty()) refuse(image, file, "has no colours");
    if (layers.size() > 1) refuse(image, file, "has colours in several layers");
    return only(image, layers.front());
}

}  // namespace plumb
