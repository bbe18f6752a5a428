#pragma once

#include <vector>

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// A pixel whose filter reaches a film point, and the filter's density there, per pixel².
struct ReachedPixel {
    int x, y;
    double density;
};
/// Finds the reached pixels of the region; they replace what `pixels` held.
void find_reached(const Filter& filter, const FilmRegion& region, const Point<2>& film,
                  std::vector<ReachedPixel>& pixels);

/// Light that a path brings to a pixel of the film, whichever pixel the path belongs to.
struct SplatOnPixel {
    int x, y;
    Spectrum value;
};
/// Adds what a path's splats anywhere bring to the pixels of the crop. Each sample of each pixel is a path that may
/// light every pixel: from each splat a pixel takes the share of one of its own samples.
void spread(const PathRecord& record, const Filter& filter, const FilmRegion& crop, std::vector<SplatOnPixel>& splats);

/// A path's estimate of the mean of the pixels that it was traced for: its own splats, and those anywhere by the
/// filter.
Spectrum region_mean(const PathRecord& record, const FilmRegion& region, const Filter& filter);

}  // namespace plumb
