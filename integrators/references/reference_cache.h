#pragma once

#include <filesystem>
#include <optional>

#include "integrators/references/provenance.h"
#include "scenes/shipped/loaded_scene.h"

namespace plumb {

/// A picture that others are measured against.
struct Reference {
    std::filesystem::path file;
    Image image;
    Provenance provenance;
};

/// The file in which the reference of a scene by an integrator is kept: CACHE/SCENE-HASH-INTEGRATOR.exr, with -dD
/// before the ending where paths end after D edges. A scene that changed has another hash, and so another file.
std::filesystem::path reference_file(const std::filesystem::path& cache, const Provenance& wanted);

/// The reference in that file; empty where there is none, or not the one that the name says, or one that another
/// version of Plumb made.
std::optional<Reference> find_reference(const std::filesystem::path& cache, const Provenance& wanted);

/// The reference of a scene for paths of these lengths (empty: of any), by the first of reference_integrators() that
/// has one. Throws Error saying how to make one.
Reference require_reference(const std::filesystem::path& cache, const NamedScene& scene,
                            std::optional<int> longest_path);

}  // namespace plumb
