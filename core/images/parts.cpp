#include "core/images/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

namespace plumb {
namespace {

// An image of another size, each of whose pixels is that of the old one which `source` gives for it, or black.
template <class Source>
Image moved(const Image& image, int width, int height, const Source& source) {
    Image result{width, height, image.channels, {}, image.metadata, image.of_integers, image.encoding};
    const std::size_t count = image.channels.size();
    result.values.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * count, 0);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto [from_x, from_y] = source(x, y);
            if (from_x < 0 || from_y < 0 || from_x >= image.width || from_y >= image.height) continue;
            const std::size_t to =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            for (std::size_t c = 0; c < count; ++c) result.values[to * count + c] = image.at(from_x, from_y, c);
        }
    return result;
}

Image displayed(const ImagePart& part) {
    const auto& [data, display] = std::pair(part.data, part.display);
    return moved(part.image, display.width, display.height, [&](int x, int y) {
        return std::array{x + display.x - data.x, y + display.y - data.y};
    });
}

// TIFF 6.0, tag 274: where the first row and the first column of what is stored are seen.
Image upright(const Image& image, int orientation) {
    const int right = image.width - 1, bottom = image.height - 1;
    const bool turned = orientation >= 5;
    const auto source = [&](int x, int y) -> std::array<int, 2> {
        switch (orientation) {
            case 2: return {right - x, y};
            case 3: return {right - x, bottom - y};
            case 4: return {x, bottom - y};
            case 5: return {y, x};
            case 6: return {y, bottom - x};
            case 7: return {right - y, bottom - x};
            case 8: return {right - y, x};
            default: return {x, y};
        }
    };
    return moved(image, turned ? image.height : image.width, turned ? image.width : image.height, source);
}

// R, G, B, A and Y, also where they are written small or as words.
std::string usual_name(const std::string& channel) {
    static const std::map<std::string, std::string> usual{{"r", "R"},     {"g", "G"},    {"b", "B"},
                                                          {"a", "A"},     {"y", "Y"},    {"red", "R"},
                                                          {"green", "G"}, {"blue", "B"}, {"alpha", "A"}};
    const std::size_t dot = channel.rfind('.'), first = dot == std::string::npos ? 0 : dot + 1;
    std::string name = channel.substr(first);
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto found = usual.find(name);
    return found == usual.end() ? channel : channel.substr(0, first) + found->second;
}

void use_usual_names(Image& image) {
    std::vector<std::string> names;
    for (const std::string& channel : image.channels) names.push_back(usual_name(channel));
    const bool distinct = std::set(names.begin(), names.end()).size() == names.size();
    if (distinct) image.channels = std::move(names);
}

// Luminance and chroma, Y, RY = (R − Y)/Y and BY = (B − Y)/Y [OpenEXR, "Luminance/Chroma Images"], as R, G and B, with
// the weights of Rec. 709's primaries.
void use_rgb(Image& image) {
    const auto index_of = [&](const char* name) {
        return static_cast<std::size_t>(std::ranges::find(image.channels, name) - image.channels.begin());
    };
    const std::size_t y = index_of("Y"), ry = index_of("RY"), by = index_of("BY"), count = image.channels.size();
    if (std::max({y, ry, by}) == count) return;
    for (std::size_t pixel = 0; pixel < image.values.size(); pixel += count) {
        const double luminance = image.values[pixel + y], r = (image.values[pixel + ry] + 1.0) * luminance,
                     b = (image.values[pixel + by] + 1.0) * luminance,
                     g = (luminance - 0.2126 * r - 0.0722 * b) / 0.7152;
        image.values[pixel + ry] = static_cast<float>(r);
        image.values[pixel + y] = static_cast<float>(g);
        image.values[pixel + by] = static_cast<float>(b);
    }
    image.channels[ry] = "R";
    image.channels[y] = "G";
    image.channels[by] = "B";
}

Image picture_of(const ImagePart& part) {
    Image image = part.data == part.display ? part.image : displayed(part);
    if (part.orientation > 1 && part.orientation <= 8) image = upright(image, part.orientation);
    use_usual_names(image);
    use_rgb(image);
    return image;
}

void name_layer(Image& image, const std::string& layer) {
    for (std::string& channel : image.channels)
        if (!layer.empty() && !channel.starts_with(layer + ".")) channel = layer + "." + channel;
}

Image joined(const Image& a, const Image& b) {
    Image both{a.width, a.height, a.channels, {}, a.metadata, a.of_integers && b.of_integers, a.encoding};
    both.channels.insert(both.channels.end(), b.channels.begin(), b.channels.end());
    both.values.reserve(a.values.size() + b.values.size());
    const std::size_t of_a = a.channels.size(), of_b = b.channels.size();
    for (std::size_t pixel = 0; pixel * of_a < a.values.size(); ++pixel) {
        const auto from_a = a.values.begin() + static_cast<std::ptrdiff_t>(pixel * of_a);
        const auto from_b = b.values.begin() + static_cast<std::ptrdiff_t>(pixel * of_b);
        both.values.insert(both.values.end(), from_a, from_a + static_cast<std::ptrdiff_t>(of_a));
        both.values.insert(both.values.end(), from_b, from_b + static_cast<std::ptrdiff_t>(of_b));
    }
    return both;
}

// The decoder of WebP multiplies colours by alpha whatever it is asked.
void require_colours(const ImageParts& parts, const Image& image) {
    const auto alpha = static_cast<std::size_t>(std::ranges::find(image.channels, "A") - image.channels.begin());
    if (parts.format != "webp" || alpha == image.channels.size()) return;
    for (std::size_t pixel = 0; pixel < image.values.size(); pixel += image.channels.size())
        if (image.values[pixel + alpha] < 1)
            throw std::invalid_argument(
                "a WebP with transparency, whose colours are read multiplied by alpha; accepted "
                "are WebP without and PNG");
}

}  // namespace

Image picture_of(ImageParts file) {
    Image whole;
    for (const ImagePart& part : file.parts) {
        Image image = picture_of(part);
        if (file.parts.size() > 1) name_layer(image, part.name);
        if (&part == &file.parts.front()) {
            whole = std::move(image);
            continue;
        }
        if (image.width != whole.width || image.height != whole.height)
            throw std::invalid_argument(
                fmt::format("its parts '{}' and '{}' have {} × {} and {} × {} pixels; accepted "
                            "are parts of one size",
                            file.parts.front().name, part.name, whole.width, whole.height, image.width, image.height));
        whole = joined(whole, image);
    }
    require_colours(file, whole);
    return whole;
}

}  // namespace plumb
