#pragma once

#include "cli/options.h"
#include "integrators/drivers/render.h"
#include "integrators/integrators.h"

namespace plumb::cli {

PathLimits limits_of(const PathOptions& options);
/// The integrator that the options name, held to their limits.
std::unique_ptr<PathEstimator> estimator_of(const PathOptions& options);
Scene load_scene(const PathOptions& options);
/// Passes and pixels; the seed is given. Throws Error for an unknown sampler, or a crop that is not within the film.
RenderSettings settings_of(const PathOptions& options, std::uint64_t seed, FilmSize film);

}  // namespace plumb::cli
