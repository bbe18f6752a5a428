#pragma once

#include <functional>

#include "verification/claim.h"
#include "verification/pictures/image_comparison.h"

namespace plumb::suites {

// The claims of `plumb compare` share what follows: images of channels R, G, B and the variances of their means in this
// order, what may be done to them, and what a comparison of two must find.

// ---- what is done to an image

/// A change of an image's values by a function of their place; its variances change by the square of that function's
/// slope.
using Change = std::function<double(double value, int x, int y)>;
Image changed(Image image, const Change& change);
/// The image with its layer of variances multiplied.
Image with_variance(Image image, double scale);

/// The image after a round trip through bytes in sRGB; the layer of variances is kept.
Image in_bytes(Image image);
/// The image with means of 3 × 3 pixels; the layer of variances is kept.
Image blurred(const Image& image);

// ---- what is found

/// One render, or independent ones of the same picture.
struct Renders {
    std::vector<Image> images;
    Renders(Image one) : images{std::move(one)} {}
    Renders(std::vector<Image> several) : images(std::move(several)) {}
};
using TwoSides = std::pair<Renders, Renders>;
/// A maker of pairs, each with random numbers of its own.
using Pair = std::function<TwoSides(std::uint64_t seed)>;

ImageComparison compared(const TwoSides& sides, double alpha, int tile = 0);
bool is_refuted(const TwoSides& sides, double alpha);

/// Two renders, and the place where a defect of the second shows; a place without pixels means all over the picture.
struct Compared {
    Pair pair;
    PixelBox place = {};
};
using Spoiled = Wrong<Compared>;

/// The comparison's verdict, in which a refutation counts only where the tile that differs most touches the place, or
/// anywhere where the place has no pixels. `tile` is as in ComparisonSettings.
Verdict comparison_shows(const Compared& subject, const Run& run, int tile = 0);

/// The verdict on 200 pairs (2000 in full) at 1e-5 each: refuted when there are more false alarms than that allows;
/// holds when the upper bound of their rate is below 5 %.
Verdict pairs_are_not_refuted(const std::function<TwoSides(std::uint64_t number, RandomStream& random)>& pair,
                              const Run& run);

}  // namespace plumb::suites
