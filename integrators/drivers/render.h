#pragma once

#include <functional>
#include <string>

#include "integrators/paths/path_estimator.h"
#include "scenes/film/film.h"

namespace plumb {

/// Which paths, in which passes. A pass is a replicate of the whole image: passes give the variance.
struct RenderSettings {
    std::string sampler = "independent";  ///< see sampler.h
    std::uint32_t samples_per_pass = 4;   ///< of each pixel
    std::uint32_t passes = 16;
    std::uint64_t seed = 1;
    FilmRegion crop = {};  ///< which pixels of the film
    /// Of the passes those first, first + step, …: a part of the render. Films of all parts merge into the whole's.
    std::uint32_t first_pass = 0, pass_step = 1;
};

/// Samples a pixel cut into passes: as near to 16 passes as divides them.
RenderSettings with_samples(RenderSettings settings, std::uint32_t samples_per_pixel);

/// Of the passes those i, i + n, …, counted from 1. Throws Error where some of the n parts had none.
RenderSettings part_of(RenderSettings settings, std::uint32_t i, std::uint32_t n);

/// The numbers of one sample of a pixel: those of pass p are samples_per_pass from p · samples_per_pass on.
PathKey path_key(const Scene& scene, const RenderSettings& settings, int x, int y, std::uint32_t sample);

/// Throws Error for a crop that is not within the film.
void check_crop(const FilmRegion& crop, FilmSize film);

struct Rendered {
    Film film;
    std::uint64_t rays = 0;
};

/// How far a render is: tiles done, of all those of all passes.
struct RenderProgress {
    std::uint64_t done, total;
};

/// Layers of a render: radiance, then what the camera sees first (albedo, normal, depth), by the same samples.
std::vector<FilmLayer> render_layers();

/// Renders pass after pass, tiles in parallel. `go_on` hears of each tile, one call at a time; when it answers false
/// after a pass, the render ends there. The same settings give the same bits on any number of threads.
Rendered render(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings,
                const std::function<bool(const RenderProgress&)>& go_on = {});

}  // namespace plumb
