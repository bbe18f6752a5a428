#pragma once

#include <functional>

#include "estimators/replicates/integration.h"
#include "integrators/drivers/render.h"
#include "scenes/film/film_error.h"

namespace plumb {

inline bool meets(const FilmError& error, const ErrorTarget& target) {
    return (target.relative ? error.relative : error.rmse) <= target.error;
}

/// A render that ended by itself.
struct RenderedUntil {
    Rendered rendered;
    FilmError error = {};
    bool met = false;  ///< false: most_passes came first
};

/// Doubles the passes from settings.passes on until the picture's error meets the target. A stop that replicates decide
/// favours those that happened to look alike; after 16 passes and at doublings alone that is little, because the error
/// is a mean over all pixels. `look` hears of each decision, `progress` of each tile of a
/// doubling. The same settings give the same bits on any number of threads.
RenderedUntil render_until(const Scene& scene, const PathEstimator& estimator, RenderSettings settings,
                           const ErrorTarget& target, std::uint32_t most_passes,
                           const std::function<void(std::uint64_t passes, const FilmError&)>& look = {},
                           const std::function<void(const RenderProgress&)>& progress = {});

}  // namespace plumb
