#include "verification/pictures/weighted_pixels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/moments.h"

namespace plumb {
namespace {

constexpr std::size_t few = 4;      // pixels under a square between them
constexpr std::size_t enough = 64;  // pixels, for a third cumulant

// The mean of a pixel's neighbours, up to eight that are finite; NaN without any, and where the pixel is four standard
// errors away: that is an edge in the picture, no noise.
double neighbours(const Picture& part, int x, int y) {
    Moments moments;
    for (int v = std::max(0, y - 1); v <= std::min(part.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(part.width - 1, x + 1); ++u)
            if ((u != x || v != y) && std::isfinite(part.mean[part.at(u, v, 0)]))
                moments.add(part.mean[part.at(u, v, 0)]);
    const std::size_t k = part.at(x, y, 0);
    const bool edge = std::abs(part.mean[k] - moments.mean()) > 4 * std::sqrt(part.variance[k]);
    return edge ? std::numeric_limits<double>::quiet_NaN() : moments.mean();
}

Picture channel_of(const Picture& picture, std::size_t channel) {
    Picture own{.width = picture.width, .height = picture.height, .channels = {picture.channels[channel]}};
    own.degrees = picture.degrees;
    for (std::size_t k = channel; k < picture.mean.size(); k += picture.channels.size()) {
        own.mean.push_back(picture.mean[k]);
        own.variance.push_back(picture.variance[k]);
    }
    return own;
}

}  // namespace

WeightedPixels pixels_under(const Picture& picture, double left, double top, double width, double height) {
    left = std::clamp(left, 0.0, picture.width - width);
    top = std::clamp(top, 0.0, picture.height - height);
    const auto shared = [](int pixel, double from, double length) {
        return (std::min(pixel + 1.0, from + length) - std::max<double>(pixel, from)) / length;
    };
    WeightedPixels pixels;
    for (int y = static_cast<int>(top); y < std::min<double>(picture.height, top + height); ++y)
        for (int x = static_cast<int>(left); x < std::min<double>(picture.width, left + width); ++x) {
            const double weight = shared(x, left, width) * shared(y, top, height);
            if (weight > 0) pixels.push_back({x, y, weight});
        }
    return pixels;
}

NoisyChannel::NoisyChannel(const Picture& picture, std::size_t channel)
    : picture_(picture), channel_(channel), own_(channel_of(picture, channel)), smooth_(own_) {
    std::ranges::fill(smooth_.variance, 0);
    for (int y = 0; y < own_.height; ++y)
        for (int x = 0; x < own_.width; ++x) smooth_.mean[smooth_.at(x, y, 0)] = neighbours(own_, x, y);
}

DifferenceSums NoisyChannel::sums(const WeightedPixels& pixels, double known) const {
    DifferenceSums sums{.pixels = 1, .b = known};
    for (const auto& [x, y, weight] : pixels) {
        const std::size_t k = picture_.at(x, y, channel_);
        if (!std::isfinite(picture_.mean[k])) return {};
        const double v = weight * weight * variance(k);
        sums.a += weight * picture_.mean[k];
        sums.variance_a += v;
        sums.rounding += std::abs(weight) * picture_.rounding_at(k);
        sums.square_a += std::isinf(picture_.degrees) ? 0 : v * v / (picture_.degrees + 2);
        if (pixels.size() < enough) continue;
        const DifferenceSums noise = sums_of(own_, smooth_, {x, y, 1, 1}, 0);
        sums.third_a += std::pow(weight, 3) * noise.third_a;
        sums.third_error_a += std::pow(weight, 6) * noise.third_error_a;
    }
    return sums;
}

DifferenceSums NoisyChannel::sums_around(const PixelBox& box) const {
    constexpr int reach = 7;
    const auto cut = [](int low, int high,
                        int length) {  // the outermost pixels lack neighbours, and those next to them
        const int edge = std::min(2, (length - 1) / 2);
        return std::pair{std::clamp(low, edge, length - edge - 1), std::clamp(high, edge + 1, length - edge)};
    };
    const auto [left, right] = cut(box.x - reach, box.x + box.width + reach, own_.width);
    const auto [top, bottom] = cut(box.y - reach, box.y + box.height + reach, own_.height);
    return sums_of(own_, smooth_, {left, top, right - left, bottom - top}, 0);
}

Inflation NoisyChannel::inflation(const WeightedPixels& pixels) const {
    double independent = 0;
    for (const auto& [x, y, weight] : pixels)
        independent += weight * weight * picture_.variance[picture_.at(x, y, channel_)];
    if (pixels.size() <= few || !(independent > 0)) return {};
    Inflation found;
    if (!picture_.mean_variance.empty()) {
        double all = 0;
        for (const double v : own_.variance) all += v;
        const auto n = static_cast<double>(own_.variance.size());
        found.a = picture_.mean_variance[channel_] / (all / n / n);
        if (pixels.size() < own_.variance.size()) found.a = std::max(1.0, found.a);
        found.degrees_a = picture_.degrees;
    } else if (picture_.residuals.size() > 1) {
        double squares = 0;
        for (const std::vector<float>& residual : picture_.residuals) {
            double sum = 0;
            for (const auto& [x, y, weight] : pixels) sum += weight * residual[picture_.at(x, y, channel_)];
            squares += sum * sum;
        }
        const auto n = static_cast<double>(picture_.residuals.size());
        found.a = squares / n / (n - 1) / independent;
        found.degrees_a = n - 1;
    }
    return found;
}

double count_of_equals(const WeightedPixels& pixels) {
    double squares = 0, cubes = 0;
    for (const PixelWeight& pixel : pixels) {
        squares += std::pow(pixel.weight, 2);
        cubes += std::pow(pixel.weight, 3);
    }
    return std::pow(squares, 3) / std::pow(cubes, 2);
}

}  // namespace plumb
