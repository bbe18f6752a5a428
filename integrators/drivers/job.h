#pragma once

#include <memory>
#include <string>
#include <vector>

#include "integrators/paths/path_estimator.h"
#include "scenes/film/film.h"

namespace plumb {

struct Driver;

/// The sampler, the samples and the passes of a render. A pass is a replicate of the whole image: passes give the
/// variance.
struct RenderSettings {
    std::string sampler = "independent";  ///< see sampler.h
    std::uint32_t samples_per_pass = 4;   ///< of each pixel
    std::uint32_t passes = 16;
    std::uint64_t seed = 1;
    FilmRegion crop = {};  ///< which pixels of the film
    /// A part of the render is the passes first, first + step, …: films of all parts merge into the whole's.
    std::uint32_t first_pass = 0, pass_step = 1;
};

/// A render before it begins. A pass is a function of the job and of its number; how many passes there are is no
/// concern of the driver, which is the same for all of them.
struct RenderJob {
    const Scene& scene;
    const PathEstimator& estimator;
    RenderSettings settings = {};
    std::shared_ptr<const Driver> driver = nullptr;
};

/// The job with the driver that every render has unless another is asked for (pixels.h).
RenderJob job_of(const Scene& scene, const PathEstimator& estimator, const RenderSettings& settings);

/// The settings with so many samples a pixel, cut into passes whose number divides them and is as near to 16 as it can
/// be. A sampler that makes sets of points over a pass is given passes of two points or more: where that rule gives
/// passes of one, as many passes as points, as nearly as can be, of one sample more where the samples are a prime
/// number. Of 1, 2 or 3 samples there are no passes of sets.
RenderSettings with_samples(RenderSettings settings, std::uint32_t samples_per_pixel);

/// Part i of n, counted from 1, which has every n-th pass. Throws Error where some part had none.
RenderSettings part_of(RenderSettings settings, std::uint32_t i, std::uint32_t n);

/// The key to the numbers of one sample of a pixel: pass p has the samples_per_pass samples from p · samples_per_pass
/// on.
PathKey path_key(const Scene& scene, const RenderSettings& settings, int x, int y, std::uint32_t sample);

/// Throws Error for a crop that is not within the film.
void check_crop(const FilmRegion& crop, FilmSize film);

/// The layers of a render: radiance, then what the camera sees first (albedo, normal, depth), by the same samples. The
/// unit of radiance is a power of two near the mean of a few paths that are the same for every seed, so that all light
/// times 2^k is the same sums in another unit.
std::vector<FilmLayer> render_layers(const RenderJob& job);

}  // namespace plumb
