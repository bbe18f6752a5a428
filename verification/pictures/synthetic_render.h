#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "core/images/image.h"
#include "core/random.h"

namespace plumb {

/// Renders without a renderer: independent pixels with a known expectation and a chosen law of noise, with variance
/// layers from replicates, for tests and claims of comparisons.
struct SyntheticRender {
    using Colour = std::array<double, 3>;
    int width = 32, height = 32;
    int replicates = 16, samples = 4;                        ///< of each pixel, and of each replicate
    std::function<Colour(int x, int y)> truth;               ///< the expectation
    std::function<double(RandomStream&, int x, int y)> law;  ///< of one sample over the truth; expectation 1

    [[nodiscard]] Image operator()(std::uint64_t seed) const {
        Image image{width, height, {"R", "G", "B", "variance.R", "variance.G", "variance.B"}, {}};
        image.metadata = {{"plumb:replicates", std::to_string(replicates)}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                RandomStream random(seed, stream_id("synthetic render"), static_cast<std::uint64_t>(y * width + x));
                double sum = 0, squares = 0;
                for (int r = 0; r < replicates; ++r) {
                    double mean = 0;
                    for (int s = 0; s < samples; ++s) mean += law(random, x, y) / samples;
                    sum += mean;
                    squares += mean * mean;
                }
                const double n = replicates, mean = sum / n;
                const double variance = std::fmax(0.0, (squares - n * mean * mean) / (n - 1) / n);
                for (const double c : truth(x, y)) image.values.push_back(static_cast<float>(c * mean));
                for (const double c : truth(x, y)) image.values.push_back(static_cast<float>(c * c * variance));
            }
        return image;
    }
};

/// Exponential noise: skewness 2.
inline double exponential_noise(RandomStream& random, int, int) {
    return -std::log1p(-random.uniform());
}

/// The same noise, in which one sample in `rarity` is `size` times its expectation.
inline auto spiky_noise(double rarity, double size) {
    return [=](RandomStream& random, int x, int y) {
        const double rest = (1 - size / rarity) / (1 - 1 / rarity);
        return random.uniform() * rarity < 1 ? size : rest * exponential_noise(random, x, y);
    };
}

}  // namespace plumb
