#pragma once

#include <vector>

#include "integrators/path_estimator.h"

namespace plumb {

/// A pixel whose filter reaches a film point, and the filter there, per pixel².
struct ReachedPixel {
    int x, y;
    double density;
};
/// Those of the region; replaces what `pixels` held.
void find_reached(const Filter& filter, const FilmRegion& region, const Point<2>& film,
                  std::vector<ReachedPixel>& pixels);

/// What a path says of the mean of the pixels it was traced for: its own splats, and those anywhere by the filter.
Spectrum region_mean(const PathRecord& record, const FilmRegion& region, const Filter& filter);

}  // namespace plumb
