#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/images/image.h"
#include "core/parameters.h"
#include "integrators/paths/limits.h"
#include "integrators/paths/path_estimator.h"
#include "scenes/film/film_error.h"

namespace plumb {

/// The data that a picture rendered by Plumb is a function of, as its metadata say it (docs/render.md): no dates, no
/// seconds, so that the same seed gives the same file.
struct Provenance {
    std::string scene = {}, scene_hash = {}, integrator = {}, sampler = {}, version = {};
    std::string driver = "pixels";
    ParameterTexts parameters = {};
    PathLimits limits = {};
    std::uint64_t seed = 0, samples_per_pixel = 0, replicates = 0;
    FilmSize film{0, 0};
    FilmRegion crop = {};
    FilmError error = {};

    /// Whether the picture counts all paths up to some length: not those of one length or strategy alone, nor albedos.
    [[nodiscard]] bool is_radiance() const;
    /// The number of edges of the longest paths that count; empty where all do.
    [[nodiscard]] std::optional<int> longest_path() const;
};

/// The longest path that the file's picture counts. Throws Error naming the file where the picture is not all light up
/// to some length.
std::optional<int> longest_path_of(const Provenance& provenance, const std::string& file);

/// Throws Error naming the file where its picture is not of this scene, to the last byte of its files.
void require_same_scene(const Provenance& said, const Provenance& scene, const std::string& file);

/// The metadata of the picture, except its error, which is known when the film is.
std::map<std::string, std::string> metadata_of(const Provenance& provenance);
std::map<std::string, std::string> metadata_of(const FilmError& error);
/// The provenance that an image's metadata say; empty for an image without `plumb:scene_hash`. Throws Error naming the
/// file and an attribute that is no number where one is due.
std::optional<Provenance> provenance_of(const Image& image, const std::string& file);

}  // namespace plumb
