#include "cli/verbs/path_options.h"

#include <CLI/CLI.hpp>

#include "cli/common_options.h"
#include "cli/values.h"
#include "integrators/drivers/sampler.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb::cli {

void add_transport(CLI::App& verb, PathOptions& options) {
    verb.add_option("scene", options.scene, "a scene in Mitsuba's XML, or the name of a shipped one")->required();
    verb.add_option("--integrator", options.integrator, "see plumb list integrators")->capture_default_str();
    verb.add_option("--sampler", options.sampler, "independent, stratified or sobol")->capture_default_str();
    verb.add_option("--max-depth", options.max_depth,
                    "longest paths, in edges from the sensor (1: lights seen directly); -1: no limit")
        ->check(CLI::Range(-1, 30000))
        ->capture_default_str();
    verb.add_option("--rr-depth", options.roulette_depth, "Russian roulette begins behind so many edges")
        ->check(CLI::Range(0, 30000))
        ->capture_default_str();
    verb.add_option_function<std::vector<std::string>>(
            "-D",
            [&](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options.definitions.insert(parse_definition(text));
            },
            "name=value for $name in the file")
        ->check(checked(parse_definition));
    verb.add_flag("--lenient", options.lenient, "replace what Plumb lacks where it can, and list it");
}

void add_paths(CLI::App& verb, PathOptions& options) {
    add_transport(verb, options);
    verb.add_option("--length", options.length, "only paths of so many edges; 0: of all")
        ->check(CLI::Range(0, 30000))
        ->capture_default_str();
    add_parsed(verb, "--strategy", options.strategy, parse_strategy,
               "of `bdpt`, one alone and unweighted: s,t for s vertices from the light and t from the sensor");
    verb.add_option("--spp", options.samples_per_pixel, "samples a pixel")
        ->check(CLI::Range(1u, 1u << 24))
        ->capture_default_str();
    add_parsed(verb, "--crop", options.crop, parse_crop, "only these pixels: x,y,width,height");
}

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
