#pragma once

#include <functional>
#include <limits>

#include "estimators/replicates/integration.h"
#include "integrators/drivers/render.h"
#include "scenes/film/film_error.h"

namespace plumb {

inline bool meets(const FilmError& error, const ErrorTarget& target) {
    return (target.relative ? error.relative : error.rmse) <= target.error;
}

/// What a picture's error rests on. Replicates know nothing of light that no path has met, and little of what few have
/// brought: then their error may be far too small, and no error is better than that one.
struct ErrorGrounds {
    /// The relative standard error of the variance (error_of_variance).
    double variance_error = std::numeric_limits<double>::infinity();
    /// How often the light that is chosen most seldom was expected to be chosen, by one choice a sample.
    double choices_of_rarest_light = 0;

    /// At most ¼: from 16 spikes on. Of what 16 samples are expected to meet all miss it with probability e^-16
    /// (docs/statistics.md asks as much of claims that can spike).
    [[nodiscard]] bool few_carry_much() const { return !(variance_error <= 0.25); }
    [[nodiscard]] bool light_may_be_missing() const { return choices_of_rarest_light < 16; }
    [[nodiscard]] bool trusted() const { return !few_carry_much() && !light_may_be_missing(); }
};

/// A render that ended by itself.
struct RenderedUntil {
    Rendered rendered;
    FilmError error = {};
    ErrorGrounds grounds = {};
    bool met = false;  ///< the error is within the target, and can be trusted; false: most_passes came first
};

/// The listeners to a render that doubles its passes.
struct DoublingProgress {
    std::function<void(std::uint64_t passes, const FilmError&)> look;  ///< of each decision
    std::function<void(const RenderProgress&)> progress;               ///< within a doubling
};

/// Doubles the passes, beginning with the job's, until the picture's error meets the target and can be trusted. A stop
/// that replicates decide favours those that happened to look alike; after 16 passes and at doublings alone that effect
/// is small, because the error is a mean over all pixels. The same job gives the same bits on any number of threads.
RenderedUntil render_until(RenderJob job, const ErrorTarget& target, std::uint32_t most_passes,
                           const DoublingProgress& hears = {});

}  // namespace plumb
