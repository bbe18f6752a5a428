#pragma once

#include <vector>

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// A pixel whose filter reaches a film point, and the filter there, per pixel².
struct ReachedPixel {
    int x, y;
    double density;
};
/// Those of the region; replaces what `pixels` held.
void find_reached(const Filter& filter, const FilmRegion& region, const Point<2>& film,
                  std::vector<ReachedPixel>& pixels);

/// Light for a pixel of the film, of a path that belongs to any.
struct SplatOnPixel {
    int x, y;
    Spectrum value;
};
/// Adds what a path's splats anywhere bring to the pixels of the crop. Each sample of each of them is a path that may
/// light every pixel: of each splat a pixel takes the share of one sample of its own.
void spread(const PathRecord& record, const Filter& filter, const FilmRegion& crop, std::vector<SplatOnPixel>& splats);

/// What a path says of the mean of the pixels it was traced for: its own splats, and those anywhere by the filter.
Spectrum region_mean(const PathRecord& record, const FilmRegion& region, const Filter& filter);

}  // namespace plumb
