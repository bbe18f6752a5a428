#pragma once

#include <vector>

namespace plumb::flip {

// The filters of FLIP [Andersson et al. 2020], each a product of one along x and one along y, or a sum of such. Their
// size follows from the number of pixels in a degree of the field of view.

/// Numbers of pixels, row by row.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> values = {};
};

/// Weights at −r … r.
using Weights = std::vector<double>;

/// A part of a contrast sensitivity function: weights of sum 1 along each axis, and its share of the whole.
struct Blur {
    Weights weights;
    double share = 1;
};
/// The contrast sensitivity functions of YCxCz's numbers: achromatic, red-green, and blue-yellow, which has two parts.
std::vector<Blur> contrast_sensitivity(int number, double pixels_per_degree);

/// A Gaussian of sum 1 with its first and second derivatives, whose positive weights have sum 1, and negative ones −1.
struct FeatureFilters {
    Weights smooth, edge, point;
};
FeatureFilters feature_filters(double pixels_per_degree);

/// Sums along an axis with these weights; beyond the border stands what stands at it.
Plane along_x(const Plane& plane, const Weights& weights);
Plane along_y(const Plane& plane, const Weights& weights);

}  // namespace plumb::flip
