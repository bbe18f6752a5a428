#include "verification/pictures/picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

#include "core/error.h"
#include "core/images/layers.h"
#include "core/srgb.h"

namespace plumb {
namespace {

std::optional<std::size_t> channel_index(const Image& image, const std::string& name) {
    const auto found = std::ranges::find(image.channels, name);
    if (found == image.channels.end()) return {};
    return static_cast<std::size_t>(found - image.channels.begin());
}

std::vector<std::string> colours_of(const Image& image, const std::string& name) {
    std::vector<std::string> colours = plumb::colours_of(image);
    if (!colours.empty()) return colours;
    throw Error(fmt::format("{}: has channels {}; accepted: R, G and B, or X, Y and Z, or Y", name,
                            fmt::join(image.channels, ", ")));
}

std::vector<std::size_t> indices(const Image& image, const std::string& name,
                                 const std::vector<std::string>& channels) {
    std::vector<std::size_t> found;
    for (const std::string& channel : channels) {
        const std::optional<std::size_t> index = channel_index(image, channel);
        if (!index) throw Error(fmt::format("{}: has no channel {}, which the first image has", name, channel));
        found.push_back(*index);
    }
    return found;
}

std::size_t variances_among(const Image& image, const std::vector<std::string>& channels) {
    const auto known = [&](const std::string& c) { return channel_index(image, "variance." + c).has_value(); };
    return static_cast<std::size_t>(std::ranges::count_if(channels, known));
}

double replicates_of(const Image& image, const std::string& name) {
    const auto text = image.metadata.find("plumb:replicates");
    if (text == image.metadata.end())
        throw Error(
            fmt::format("{}: has variance layers, but no attribute plumb:replicates that says of how many "
                        "replicates",
                        name));
    std::uint64_t count = 0;
    std::from_chars(text->second.data(), text->second.data() + text->second.size(), count);
    if (count < 2)
        throw Error(fmt::format("{}: a variance needs two replicates or more, not plumb:replicates = '{}'", name,
                                text->second));
    return static_cast<double>(count);
}

/// Numbers that an attribute has, with spaces between them; none where it is missing, or has other text.
std::vector<double> numbers_of(const Image& image, const char* attribute) {
    const auto found = image.metadata.find(attribute);
    if (found == image.metadata.end()) return {};
    std::istringstream text(found->second);
    return {std::istream_iterator<double>(text), {}};
}

bool is_half(float x) {
    if (!std::isfinite(x)) return true;
    int exponent = 0;
    const float digits = std::ldexp(std::frexp(x, &exponent), 11);
    return digits == std::round(digits) && std::ldexp(x, 24) == std::round(std::ldexp(x, 24));
}

// Numbers that all are halves, and so many that they would hardly be if they had not been rounded to halves.
bool were_rounded_to_halves(const Image& image) {
    constexpr std::size_t enough = 16;
    std::set<float> distinct;
    for (const float value : image.values) {
        if (!is_half(value)) return false;
        if (distinct.size() < enough && value != 0 && std::isfinite(value)) distinct.insert(value);
    }
    return distinct.size() == enough;
}

// Half of a unit in the last place: of half floats where every number is one, else of floats.
void set_rounding(Picture& picture, const Image& image) {
    constexpr double half = 0x1p-11, single = 0x1p-24, least_half = 0x1p-25;
    picture.rounding = std::max(picture.rounding, std::ranges::all_of(image.values, is_half) ? half : single);
    if (!were_rounded_to_halves(image)) return;
    picture.least_rounding = picture.variance_rounding = least_half;
}

double samples_of(std::span<const Image> renders) {
    double sum = 0;
    for (const Image& image : renders) {
        const std::vector<double> samples = numbers_of(image, "plumb:spp");
        if (samples.size() != 1) return 0;
        sum += samples[0];
    }
    return sum;
}

void average(Picture& picture, std::span<const Image> renders, const std::vector<std::vector<std::size_t>>& sources) {
    const std::size_t count = picture.channels.size();
    const auto n = static_cast<double>(renders.size());
    for (std::size_t i = 0; i < renders.size(); ++i) {
        const std::size_t stride = renders[i].channels.size();
        for (std::size_t k = 0; k < picture.mean.size(); ++k) {
            const float value = renders[i].values[k / count * stride + sources[i][k % count]];
            picture.mean[k] += std::isfinite(value) ? value / n : std::numeric_limits<double>::quiet_NaN();
        }
    }
}

void variance_of_layers(Picture& picture, std::span<const Image> renders, std::span<const std::string> names) {
    const std::size_t count = picture.channels.size();
    const auto n = static_cast<double>(renders.size());
    for (std::size_t i = 0; i < renders.size(); ++i) {
        std::vector<std::string> layers;
        for (const std::string& channel : picture.channels) layers.push_back("variance." + channel);
        const std::vector<std::size_t> source = indices(renders[i], names[i], layers);
        for (std::size_t k = 0; k < picture.variance.size(); ++k)
            picture.variance[k] +=
                renders[i].values[k / count * renders[i].channels.size() + source[k % count]] / n / n;
        picture.degrees += replicates_of(renders[i], names[i]) - 1;
    }
    picture.mean_variance.assign(count, 0);
    for (const Image& image : renders) {
        const std::vector<double> errors = numbers_of(image, "plumb:error_of_means");
        if (errors.size() != count) return picture.mean_variance.clear();
        for (std::size_t c = 0; c < count; ++c) picture.mean_variance[c] += errors[c] * errors[c] / n / n;
    }
}

void find_residuals(Picture& picture, std::span<const Image> renders,
                    const std::vector<std::vector<std::size_t>>& sources) {
    const std::size_t count = picture.channels.size();
    picture.residuals.resize(renders.size());
    for (std::size_t i = 0; i < renders.size(); ++i)
        for (std::size_t k = 0; k < picture.mean.size(); ++k)
            picture.residuals[i].push_back(static_cast<float>(
                renders[i].values[k / count * renders[i].channels.size() + sources[i][k % count]] - picture.mean[k]));
}

void variance_of_spread(Picture& picture) {
    const auto n = static_cast<double>(picture.residuals.size());
    for (const std::vector<float>& residual : picture.residuals)
        for (std::size_t k = 0; k < residual.size(); ++k)
            picture.variance[k] += static_cast<double>(residual[k]) * residual[k] / n / (n - 1);
    picture.degrees = n - 1;
}

// Numbers of an image as amounts of light.
void make_linear(Image& image, const std::string& name) {
    const auto& [encoding, gamma] = image.encoding;
    if ((encoding.empty() && !image.of_integers) || encoding == "Linear" || encoding == "linear") return;
    if (gamma <= 0 && !encoding.empty() && encoding != "sRGB" && encoding != "Rec709")
        throw Error(fmt::format(
            "{}: its colours are encoded as '{}'; accepted are linear ones, sRGB, Rec709 and powers", name, encoding));
    for (float& value : image.values)
        value = gamma > 0 ? std::pow(value, static_cast<float>(gamma)) : linear_from_srgb(value);
}

// A pixel with one bad channel is bad: it can be seen in no other way than as a whole.
void exclude_bad(Picture& picture) {
    const std::size_t count = picture.channels.size();
    for (std::size_t p = 0; p < picture.mean.size(); p += count) {
        bool bad = false;
        for (std::size_t k = p; k < p + count; ++k)
            bad = bad || !std::isfinite(picture.mean[k]) || !std::isfinite(picture.variance[k]) ||
                  picture.variance[k] < 0;
        if (!bad) continue;
        ++picture.bad_pixels;
        std::fill_n(picture.mean.begin() + static_cast<std::ptrdiff_t>(p), count,
                    std::numeric_limits<double>::quiet_NaN());
    }
}

}  // namespace

Picture picture_of(std::span<const Image> renders, std::span<const std::string> names, bool exact) {
    const Image& first = renders.front();
    Picture picture{.width = first.width, .height = first.height, .channels = colours_of(first, names[0])};
    picture.renders = renders.size();
    picture.samples = samples_of(renders);
    std::vector<std::vector<std::size_t>> sources;
    bool layers = true;
    for (std::size_t i = 0; i < renders.size(); ++i) {
        if (renders[i].width != first.width || renders[i].height != first.height)
            throw Error(fmt::format("{}: is {}x{} pixels, {} {}x{}", names[i], renders[i].width, renders[i].height,
                                    names[0], first.width, first.height));
        if (renders[i].of_integers)
            throw Error(
                fmt::format("{}: stores integers, which are cut off and rounded; a comparison needs floats, e.g. "
                            "EXR",
                            names[i]));
        sources.push_back(indices(renders[i], names[i], picture.channels));
        layers = layers && variances_among(renders[i], picture.channels) == picture.channels.size();
        set_rounding(picture, renders[i]);
    }
    picture.mean.assign(
        static_cast<std::size_t>(first.width) * static_cast<std::size_t>(first.height) * picture.channels.size(), 0);
    picture.variance.assign(picture.mean.size(), 0);
    average(picture, renders, sources);
    if (renders.size() > 1 && !exact) find_residuals(picture, renders, sources);
    if (exact || !layers) picture.variance_rounding = 0;
    if (exact)
        picture.degrees = std::numeric_limits<double>::infinity();
    else if (layers)
        variance_of_layers(picture, renders, names);
    else if (renders.size() > 1)
        variance_of_spread(picture);
    else
        throw Error(
            fmt::format("{}: one image without layers variance.{} …, so its error is unknown; give two or more "
                        "independent renders of it (--a or --b), or say --exact-b when b has no error",
                        names[0], picture.channels[0]));
    exclude_bad(picture);
    return picture;
}

Picture picture_without_error(const Image& image, const std::string& name) {
    Image light = image;
    make_linear(light, name);
    light.of_integers = false;
    Picture picture = picture_of(std::span(&light, 1), std::span(&name, 1), true);
    if (image.of_integers) picture.rounding = 0x1p-9;
    picture.degrees = 0;
    picture.error_known = false;
    return picture;
}

bool has_variance(const Image& image, const std::string& name) {
    const std::vector<std::string> channels = colours_of(image, name);
    const std::size_t known = variances_among(image, channels);
    if (known > 0 && known < channels.size())
        throw Error(fmt::format("{}: has layers variance.… for {} of its {} channels; accepted: all or none", name,
                                known, channels.size()));
    return known > 0;
}

void require_independent(std::span<const Image> images, std::span<const std::string> names) {
    const auto text = [](const Image& image, const char* key) {
        const auto found = image.metadata.find(key);
        return found == image.metadata.end() ? std::string() : found->second;
    };
    for (std::size_t i = 0; i < images.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::string seed = text(images[i], "plumb:seed"), scene = text(images[i], "plumb:scene_hash");
            if (seed.empty() || seed != text(images[j], "plumb:seed") || scene != text(images[j], "plumb:scene_hash"))
                continue;
            throw Error(
                fmt::format("{} and {}: both have seed {} and the same scene, so they share random numbers and "
                            "the error of their difference is unknown; render one with another --seed",
                            names[j], names[i], seed));
        }
}

}  // namespace plumb
