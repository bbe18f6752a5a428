#pragma once

#include <string>

#include "core/estimate.h"
#include "integrators/paths/path_estimator.h"

namespace plumb {

/// The mean luminance of the region's pixels, estimated by n paths of one sample set; evaluations counts rays.
Estimate region_estimate(const Scene& scene, const PathEstimator& estimator, const std::string& sampler,
                         const FilmRegion& region, std::uint64_t n, std::uint64_t seed);

}  // namespace plumb
