#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrators/drivers/render.h"
#include "integrators/method.h"

namespace CLI {
class App;
}

namespace plumb::cli {

/// A scene, and which of its paths are made.
struct PathOptions {
    std::string scene;  ///< a file, or the name of a shipped one
    std::string integrator = "direct", driver = "pixels", sampler = "independent";
    ParameterTexts parameters;               ///< of any of these
    int max_depth = -1, roulette_depth = 5;  ///< in edges; -1: no limit
    int length = 0;                          ///< in edges: paths of this length alone; 0: all
    std::vector<int> strategy;               ///< s, t of bdpt; empty: all
    std::uint32_t samples_per_pixel = 64;
    std::vector<int> crop;                           ///< x, y, width, height; empty: the whole film
    std::map<std::string, std::string> definitions;  ///< of $name in the file
    bool lenient = false;
    std::optional<std::uint64_t> seed;
};

/// The scene, and how its light is transported.
void add_transport(CLI::App& verb, PathOptions& options);
/// These, and which of its paths.
void add_paths(CLI::App& verb, PathOptions& options);

/// Integrator, driver and sampler that the options name, resolved. Throws Error for what is not accepted.
RenderMethod method_of(const PathOptions& options);
Scene load_scene(const PathOptions& options);
/// Passes and pixels; the seed is given. Throws Error for a crop that is not within the film.
RenderSettings settings_of(const PathOptions& options, std::uint64_t seed, FilmSize film);

}  // namespace plumb::cli
