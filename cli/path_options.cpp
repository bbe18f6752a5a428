#include "cli/path_options.h"

#include "integrators/drivers/sampler.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb::cli {

PathLimits limits_of(const PathOptions& options) {
    PathLimits limits{options.max_depth, options.roulette_depth, options.length};
    if (!options.strategy.empty()) limits.strategy = Strategy{options.strategy[0], options.strategy[1]};
    return limits;
}

std::unique_ptr<PathEstimator> estimator_of(const PathOptions& options) {
    return make_integrator(options.integrator, limits_of(options));
}

Scene load_scene(const PathOptions& options) {
    return Scene(load_mitsuba(scene_file(options.scene), {options.definitions, options.lenient}));
}

RenderSettings settings_of(const PathOptions& options, std::uint64_t seed, FilmSize film) {
    RenderSettings settings{.sampler = options.sampler, .seed = seed, .crop = {0, 0, film.width, film.height}};
    if (const std::vector<int>& crop = options.crop; !crop.empty())
        settings.crop = {crop[0], crop[1], crop[2], crop[3]};
    check_crop(settings.crop, film);
    Sampler(settings.sampler, 1);  // knows the name, or says so before the work begins
    return with_samples(settings, options.samples_per_pixel);
}

}  // namespace plumb::cli
