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

/// The listeners to a render that doubles its passes.
struct DoublingProgress {
    std::function<void(std::uint64_t passes, const FilmError&)> look;  ///< of each decision
    std::function<void(const RenderProgress&)> progress;               ///< within a doubling
};

/// Doubles the passes, beginning with the job's, until the picture's error meets the target. A stop that replicates
/// decide favours those that happened to look alike; after 16 passes and at doublings alone that effect is small,
/// because the error is a mean over all pixels. The same job gives the same bits on any number of threads.
RenderedUntil render_until(RenderJob job, const ErrorTarget& target, std::uint32_t most_passes,
                           const DoublingProgress& hears = {});

}  // namespace plumb
