#include "cli/verbs/explain/picture.h"

#include <algorithm>
#include <filesystem>

#include "core/error.h"

namespace plumb::cli {
namespace {

double luminance_at(const Image& image, int x, int y) {
    constexpr std::pair<const char*, double> weights[] = {{"R", 0.2126}, {"G", 0.7152}, {"B", 0.0722}};
    double sum = 0;
    for (const auto& [name, weight] : weights) {
        const auto channel = std::ranges::find(image.channels, name);
        if (channel != image.channels.end())
            sum += weight * image.at(x, y, static_cast<std::size_t>(channel - image.channels.begin()));
    }
    return sum;
}

double median_around(const Image& image, int x, int y) {
    std::vector<double> around;
    for (int j = std::max(0, y - 2); j <= std::min(image.height - 1, y + 2); ++j)
        for (int i = std::max(0, x - 2); i <= std::min(image.width - 1, x + 2); ++i)
            if (i != x || j != y) around.push_back(luminance_at(image, i, j));
    if (around.empty()) return 0;
    const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
    std::ranges::nth_element(around, middle);
    return *middle;
}

}  // namespace

std::optional<TellingPicture> telling_picture(const std::string& scene_or_picture) {
    const std::filesystem::path file(scene_or_picture);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored) || file.extension() == ".xml") return {};
    TellingPicture picture{scene_or_picture, read_image(file), {}};
    const auto said = provenance_of(picture.image, scene_or_picture);
    if (!said)
        throw Error(
            fmt::format("{}: does not say how it was made; accepted: a scene, or an EXR or TIFF that plumb "
                        "render wrote",
                        scene_or_picture));
    picture.said = *said;
    return picture;
}

std::vector<Firefly> fireflies(const TellingPicture& picture, std::size_t most) {
    const Image& image = picture.image;
    std::vector<Firefly> all;
    double mean = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Firefly one{x + picture.said.crop.x, y + picture.said.crop.y, luminance_at(image, x, y),
                              median_around(image, x, y)};
            all.push_back(one);
            mean += one.luminance / (image.width * image.height);
        }
    const auto excess = [&](const Firefly& one) {
        return (one.luminance - one.neighbours) / (one.neighbours + 0.1 * mean);
    };
    most = std::min(most, all.size());
    std::ranges::partial_sort(all, all.begin() + static_cast<std::ptrdiff_t>(most), std::greater<>(), excess);
    all.resize(most);
    return all;
}

}  // namespace plumb::cli
