#pragma once

#include <limits>
#include <vector>

#include "verification/pictures/image_correlation.h"
#include "verification/pictures/picture.h"
#include "verification/pictures/pixel_grid.h"

namespace plumb {

/// The variance of a sum over pixels, over the sum of their variances, of each side: 1 where errors are independent,
/// more where neighbours share errors, less where they cancel.
struct Inflation {
    static constexpr double known = std::numeric_limits<double>::infinity();
    double a = 1, b = 1;
    double degrees_a = known, degrees_b = known;  ///< of freedom, of these as estimates
};

/// Of a picture's tiles, and of the picture.
struct SumInflations {
    std::vector<Inflation> tiles = {};    ///< box by box
    std::vector<Inflation> picture = {};  ///< channel by channel
    double degrees = Inflation::known;    ///< of freedom, of what all tiles' inflations have in common
    bool of_spread = false;               ///< measured on the sums of renders; else by correlations of differences
};

/// Where each side that has errors has several renders, the spread of their sums over tiles tells each side's own
/// inflation, whatever correlates the pixels of a tile: a tile's is the mean over the 5x5 tiles about it, or over 3x3
/// where that is significantly more; the picture's comes from blocks of tiles, or from the whole where that spreads
/// significantly more. Else correlations of the differences tell one for both: the picture's, or that of the 5x5 tiles
/// about a tile, without it, where that is significantly more.
SumInflations inflations_of(const Picture& a, const Picture& b, const PixelGrid& grid, const Correlation& correlation);

}  // namespace plumb
