#pragma once

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// What the camera sees first, without light: the albedo there, black where there is nothing. Normal and depth come
/// with every render.
struct Aov final : PathEstimator {
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;
};

}  // namespace plumb
