#pragma once

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// The albedo of what the camera sees first, without light; black where there is nothing. Normal and depth come with
/// every render.
struct Aov final : PathEstimator {
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;
};

}  // namespace plumb
