#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "cli/session.h"
#include "core/error_target.h"
#include "core/shard.h"
#include "integrators/method.h"
#include "scenes/shipped/loaded_scene.h"

namespace plumb::cli {

/// When a render is done, where the passes of its settings do not say it.
struct RenderEnd {
    std::optional<std::chrono::duration<double>> time;
    std::optional<ErrorTarget> error;
    std::uint32_t most_samples = 1u << 16;  ///< of a pixel, where the error is not reached
};

/// A picture, or a part of one, that is to be rendered to a file.
struct PictureTask {
    const LoadedScene& scene;
    RenderMethod method;  ///< resolved
    RenderSettings settings;
    RenderEnd end = {};
    std::optional<Shard> shard = {};  ///< of the passes, into a part of a film
    std::filesystem::path out;
    std::uint32_t samples_asked = 0;  ///< of a pixel; 0: the end decides
};

/// Renders on the session's threads, writes the file and its side record, and says how it went. Returns the program's
/// exit code. Throws Error.
int render_picture(const PictureTask& task, Session& session);

}  // namespace plumb::cli
