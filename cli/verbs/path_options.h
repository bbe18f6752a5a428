#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/verbs/render_picture.h"
#include "integrators/method.h"
#include "scenes/mitsuba/mitsuba_xml.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace plumb::cli {

/// A scene, and which of its paths are made.
struct PathOptions {
    std::string scene;                      ///< a file, or the name of a shipped one
    std::optional<std::string> integrator;  ///< empty: the scene's with its limits, or `path`
    std::string driver = "pixels", sampler = "independent";
    ParameterTexts parameters;                     ///< of any of these
    std::optional<int> max_depth, roulette_depth;  ///< in edges; max_depth -1: no limit
    int length = 0;                                ///< in edges: paths of this length alone; 0: all
    std::vector<int> strategy;                     ///< s, t of bdpt; empty: all
    std::uint32_t samples_per_pixel = 64;
    std::vector<int> crop;  ///< x, y, width, height; empty: the whole film
    LoadOptions load;       ///< of the scene
    std::optional<std::uint64_t> seed;
};

/// The scene, and how its light is transported.
void add_transport(CLI::App& verb, PathOptions& options);
/// These, and which of its paths.
void add_paths(CLI::App& verb, PathOptions& options);
/// --error and --max-spp; returns the first.
CLI::Option* add_error(CLI::App& verb, RenderEnd& end);

/// Integrator, driver and sampler that the options name, or else the scene's file, resolved. Throws Error for what is
/// not accepted.
RenderMethod method_of(const PathOptions& options, const description::Scene& scene);
/// Passes and pixels; the seed is given. Throws Error for a crop that is not within the film.
RenderSettings settings_of(const PathOptions& options, std::uint64_t seed, FilmSize film);

}  // namespace plumb::cli
