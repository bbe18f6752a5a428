#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/image.h"
#include "core/point.h"

namespace plumb {

/// The lookup that makes a function of pixels.
enum class ImageLookup {
    nearest,   ///< the pixel that holds the point
    bilinear,  ///< linear between the centres of pixels, constant in the half pixel along the border
};

/// One number a pixel as a function on [0,1]², x to the right and y downwards from the image's upper left corner. Its
/// integral is the mean of the pixels for either lookup: each pixel's hat function, cut at the border and continued
/// there as a constant, has the integral of the pixel.
class ImageFunction {
public:
    /// weights: what each channel counts, one number a channel.
    ImageFunction(std::shared_ptr<const Image> image, std::vector<double> weights, ImageLookup lookup);

    double operator()(const Point<2>& p) const;
    /// ∫ over [0,1]²: the mean of all pixels.
    [[nodiscard]] double integral() const;

private:
    [[nodiscard]] double pixel(int x, int y) const;

    std::shared_ptr<const Image> image_;
    std::vector<double> weights_;
    ImageLookup lookup_;
};

/// The weights of a channel by its name, or of "luminance" (Rec. 709: 0.2126 R + 0.7152 G + 0.0722 B of the file's own
/// numbers); throws Error naming the nearest one.
std::vector<double> channel_weights(const Image& image, const std::string& channel);

/// What channel_weights() knows: the image's channels, and luminance where it has R, G and B.
std::vector<std::string> channel_names(const Image& image);

}  // namespace plumb
