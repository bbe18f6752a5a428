#include "cli/verbs/path_options.h"

#include <CLI/CLI.hpp>

#include "cli/common_options.h"
#include "cli/values.h"

namespace plumb::cli {

void add_transport(CLI::App& verb, PathOptions& options) {
    verb.add_option("scene", options.scene, "a scene in Mitsuba's XML, or the name of a shipped one")->required();
    const std::string otherwise =
        options.integrator.value_or("the scene's with its limits, where Plumb has it, or path");
    verb.add_option("--integrator", options.integrator,
                    fmt::format("what a path is: see plumb list integrators [{}]", otherwise));
    verb.add_option("--driver", options.driver, "which paths, in which passes: see plumb list drivers")
        ->capture_default_str();
    verb.add_option("--sampler", options.sampler,
                    "where random numbers come from: see plumb list samplers; sobol is short for sobol-owen")
        ->capture_default_str();
    verb.add_option_function<std::vector<std::string>>(
            "-P",
            [&](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options.parameters.insert(parse_parameter(text));
            },
            "a parameter of the integrator or the driver, name=value; may be given several times")
        ->check(checked(parse_parameter));
    verb.add_option("--max-depth", options.max_depth,
                    "the longest paths, in edges from the sensor (1: lights seen directly); -1: no limit [-1]")
        ->check(CLI::Range(-1, 30000));
    verb.add_option("--rr-depth", options.roulette_depth,
                    "how many edges a path has before Russian roulette begins [5]")
        ->check(CLI::Range(0, 30000));
    verb.add_option_function<std::vector<std::string>>(
            "-D",
            [&](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options.load.definitions.insert(parse_definition(text));
            },
            "what $name stands for in the scene's file, name=value; may be given several times")
        ->check(checked(parse_definition));
    verb.add_flag("--lenient", options.load.lenient, "replace what Plumb lacks where it can, and list it");
}

void add_paths(CLI::App& verb, PathOptions& options) {
    add_transport(verb, options);
    verb.add_option("--length", options.length, "trace only paths of so many edges; 0: of any number")
        ->check(CLI::Range(0, 30000))
        ->capture_default_str();
    add_parsed(verb, "--strategy", options.strategy, parse_strategy,
               "one strategy of bdpt, alone and unweighted: s,t for s vertices from the light and t from the sensor");
    add_count(verb, "--spp", options.samples_per_pixel, 1, 1u << 24, "samples of each pixel");
    add_parsed(verb, "--crop", options.crop, parse_crop, "render only these pixels: x,y,width,height");
}

CLI::Option* add_error(CLI::App& verb, RenderEnd& end) {
    CLI::Option* error = add_parsed(verb, "--error", end.error, parse_error_target,
                                    "double the passes until the picture's RMSE is at most this, 1e-3, or 1% of the "
                                    "picture");
    add_count(verb, "--max-spp", end.most_samples, 64, 1u << 24, "samples of each pixel at which --error gives up")
        ->needs(error);
    return error;
}

RenderMethod method_of(const PathOptions& options, const description::Scene& scene) {
    const description::Integrator asked = options.integrator
                                              ? description::Integrator{.name = *options.integrator}
                                              : scene.integrator.value_or(description::Integrator{.name = "path"});
    const auto first = [](std::optional<int> given, std::optional<int> advised, int otherwise) {
        return given ? *given : advised.value_or(otherwise);
    };
    const PathLimits defaults;
    PathLimits limits{first(options.max_depth, asked.longest, defaults.max_edges),
                      first(options.roulette_depth, asked.roulette_at, defaults.roulette_edges), options.length};
    if (!options.strategy.empty()) limits.strategy = Strategy{options.strategy[0], options.strategy[1]};
    return resolved({asked.name, options.driver, options.sampler, limits, options.parameters});
}

RenderSettings settings_of(const PathOptions& options, std::uint64_t seed, FilmSize film) {
    RenderSettings settings{.sampler = options.sampler, .seed = seed, .crop = {0, 0, film.width, film.height}};
    if (const std::vector<int>& crop = options.crop; !crop.empty())
        settings.crop = {crop[0], crop[1], crop[2], crop[3]};
    check_crop(settings.crop, film);
    return with_samples(settings, options.samples_per_pixel);
}

}  // namespace plumb::cli
