#pragma once

#include <vector>

#include "verification/pictures/mean_difference.h"
#include "verification/pictures/picture.h"
#include "verification/pictures/pixel_grid.h"

namespace plumb {

// Weighted sums over pixels of one picture: means over squares between pixels, over rectangles, over the film, and what
// several such have in common.

struct PixelWeight {
    int x, y;
    double weight;
};
using WeightedPixels = std::vector<PixelWeight>;

/// The pixels under a rectangle, weighted by the areas that they share with it, of sum 1: their weighted sum is the
/// mean over it. Where it lies across an edge of the picture it is moved inside.
WeightedPixels pixels_under(const Picture& picture, double left, double top, double width, double height);

/// One channel of a picture, and how its noise is skewed.
class NoisyChannel {
public:
    NoisyChannel(const Picture& picture, std::size_t channel);

    /// The weighted sum, as the sums over a single pixel, against a known value; of no pixels where one is not finite.
    /// With its third cumulant where the pixels are as many as a tile's: fewer tell too little of it.
    [[nodiscard]] DifferenceSums sums(const WeightedPixels& pixels, double known) const;

    /// The sums over the box and seven pixels about it, whose skewness is taken for that of sums within. Each pixel is
    /// compared with the mean of its neighbours, and sums_of() takes off what its neighbours differ by from theirs: a
    /// picture that is quadratic in x and y leaves nothing but noise.
    [[nodiscard]] DifferenceSums sums_around(const PixelBox& box) const;

    /// The inflation of the variance of a sum by what its pixels have in common: by the spread of several renders; for
    /// one render that says the error of its whole mean, by that, and at least 1 for less than the whole; else 1, which
    /// it is also taken for over the four pixels of a square.
    [[nodiscard]] Inflation inflation(const WeightedPixels& pixels) const;

private:
    [[nodiscard]] double variance(std::size_t k) const { return picture_.variance[k] + picture_.variance_rounding; }

    const Picture& picture_;
    std::size_t channel_;
    Picture own_, smooth_;
};

/// How many pixels, alike in weight, have a sum as skewed as this one: (Σw²)³/(Σw³)².
double count_of_equals(const WeightedPixels& pixels);

}  // namespace plumb
