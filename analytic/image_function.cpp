#include "analytic/image_function.h"

#include <algorithm>
#include <cmath>

#include "core/named.h"

namespace plumb {
namespace {

constexpr std::pair<const char*, double> luminance[] = {{"R", 0.2126}, {"G", 0.7152}, {"B", 0.0722}};

std::size_t index_of(const Image& image, std::string_view channel) {
    return static_cast<std::size_t>(std::ranges::find(image.channels, channel) - image.channels.begin());
}

}  // namespace

ImageFunction::ImageFunction(std::shared_ptr<const Image> image, std::vector<double> weights, ImageLookup lookup)
    : image_(std::move(image)), weights_(std::move(weights)), lookup_(lookup) {}

double ImageFunction::pixel(int x, int y) const {
    double sum = 0;
    for (std::size_t c = 0; c < weights_.size(); ++c)
        if (weights_[c] != 0) sum += weights_[c] * static_cast<double>(image_->at(x, y, c));
    return sum;
}

double ImageFunction::operator()(const Point<2>& p) const {
    const int right = image_->width - 1, bottom = image_->height - 1;
    const double x = p[0] * image_->width, y = p[1] * image_->height;
    if (lookup_ == ImageLookup::nearest)
        return pixel(std::min(static_cast<int>(x), right), std::min(static_cast<int>(y), bottom));
    const int left = static_cast<int>(std::floor(x - 0.5)), above = static_cast<int>(std::floor(y - 0.5));
    const double s = x - 0.5 - left, t = y - 0.5 - above;
    const auto row = [&](int j) {
        return std::lerp(pixel(std::max(left, 0), j), pixel(std::min(left + 1, right), j), s);
    };
    return std::lerp(row(std::max(above, 0)), row(std::min(above + 1, bottom)), t);
}

double ImageFunction::integral() const {
    double sum = 0;
    for (int y = 0; y < image_->height; ++y) {
        double row = 0;
        for (int x = 0; x < image_->width; ++x) row += pixel(x, y);
        sum += row / image_->width;
    }
    return sum / image_->height;
}

std::vector<double> channel_weights(const Image& image, const std::string& channel) {
    (void)find_named(channel_names(image), channel, "channel", std::identity{});
    std::vector<double> weights(image.channels.size());
    if (const std::size_t index = index_of(image, channel); index < weights.size())
        weights[index] = 1;
    else
        for (const auto& [name, weight] : luminance) weights[index_of(image, name)] = weight;
    return weights;
}

std::vector<std::string> channel_names(const Image& image) {
    std::vector<std::string> names = image.channels;
    const auto here = [&](const auto& part) { return index_of(image, part.first) < image.channels.size(); };
    if (std::ranges::all_of(luminance, here)) names.emplace_back("luminance");
    return names;
}

}  // namespace plumb
