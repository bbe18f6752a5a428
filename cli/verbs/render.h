#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "cli/verbs/path_options.h"
#include "core/error_target.h"
#include "core/shard.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace plumb::cli {

struct RenderOptions : PathOptions {
    std::optional<std::chrono::duration<double>> time;  ///< instead of samples_per_pixel
    std::optional<ErrorTarget> error;                   ///< instead
    std::uint32_t most_samples = 1u << 16;              ///< of a pixel, where the error is not reached
    std::optional<Shard> shard;                         ///< of the passes, into a part of a film
    int threads = 0;
    std::string out;  ///< empty: out/SCENE.exr
};

/// --error and --max-spp; returns the first.
CLI::Option* add_error(CLI::App& verb, RenderOptions& options);

/// Renders the scene that `load` gives to a file; the program's exit code. Throws Error.
int render(const RenderOptions& options, const std::function<Scene()>& load);

}  // namespace plumb::cli
