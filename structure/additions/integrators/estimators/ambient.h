#pragma once

#include "core/parameters.h"
#include "integrators/paths/limits.h"
#include "integrators/paths/path_estimator.h"

namespace plumb {

/// Paths sensor – surface – sky: what is seen first as a white sky around the scene would light it, other lights off,
///   ∫ f(wo, wi) |cos θ| V(wi) dω,
/// V being 1 where nothing hides the sky, by directions of the BSDF.
struct Ambient final : PathEstimator {
    void trace(const Scene& scene, const FilmRegion& region, PrimarySamples& samples,
               PathRecord& record) const override;
};

std::unique_ptr<PathEstimator> make_ambient(const PathLimits& limits, const Parameters& parameters);

}  // namespace plumb
