#pragma once

#include <functional>

#include "verification/pictures/picture.h"
#include "verification/pictures/pixel_grid.h"

namespace plumb {

// Pixel by pixel: are squared differences of the size that their variances say? What pixels have in common changes
// neither expectation, and the spread of the means of tiles shows what it does to the error.

/// A mean over pixels, and the probability of one so far on the side that is tested.
struct SquaresTest {
    double ratio = 1;
    double p_value = 1;
};

/// Are they smaller? The mean of squared t, bounded, is 1 or more for independent pictures. `inflation`: of the
/// variance of sums over pixels.
SquaresTest too_alike(const Picture& a, const Picture& b, const PixelGrid& grid, double inflation);

/// Are they larger? (d² − v)/V, with V the mean variance of the 5x5 tiles about, has expectation 0 for estimates of the
/// same picture, whatever the law of their errors, and less once it is cut at 8: blurred edges, pictures moved aside
/// and wrong textures show here though the means of tiles are right. `allowed(box, channel)`: an absolute difference
/// that is none. The ratio is 1 more than the mean.
SquaresTest too_unlike(const Picture& a, const Picture& b, const PixelGrid& grid, double inflation,
                       const std::function<double(const PixelBox&, std::size_t channel)>& allowed);

}  // namespace plumb
