#pragma once

#include <limits>
#include <vector>

#include "verification/pictures/picture.h"
#include "verification/pictures/pixel_grid.h"

namespace plumb {

/// The correlation of the errors of neighbouring pixels, which a reconstruction filter or a denoiser brings about.
struct Correlation {
    int reach = 0;          ///< pixels; 0: none was found
    double inflation = 1;   ///< of the variance of a sum over many pixels: 1 + the sum of all correlations
    double resolution = 0;  ///< an inflation less 1 that could have been missed (three standard errors)
    double degrees = std::numeric_limits<double>::infinity();  ///< of freedom, of the inflation as an estimate
    double bias = 0;                                           ///< a part of all products that is a bias's
};

/// The correlations at distances of one pixel, of two, …, up to the first distance at which they are not significant
/// (three standard errors) or `farthest`. Where there are several renders of each picture, they come from the
/// deviations of renders from their means. Else they come from differences, less what the surroundings differ by, and
/// less the excess of squared differences over the variances where that is significant: it is a bias's.
Correlation correlation_of(const Picture& a, const Picture& b, int farthest = 6);

/// The same about one tile.
struct LocalCorrelation {
    double inflation = 1;
    double excess = 0;  ///< over the picture's inflation, in standard errors
    double degrees = std::numeric_limits<double>::infinity();
};

/// Of the differences in the 5x5 tiles about each tile, without its own: what it is judged by must not be its own bias.
std::vector<LocalCorrelation> correlations_about(const Picture& a, const Picture& b, const PixelGrid& grid,
                                                 const Correlation& picture);

}  // namespace plumb
