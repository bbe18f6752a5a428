#pragma once

#include <filesystem>

#include "scenes/description/mesh.h"

namespace plumb {

/// Reads a Wavefront OBJ: v, vt, vn and f (polygons become fans, negative indices count back). Groups and materials are
/// skipped, as a scene's materials come from the scene. v of vt becomes 1 − v, as v grows downwards here. A face needs
/// uvs (or normals) at all its corners; a mesh has them when all its faces do. Throws Error with file and line.
Mesh read_obj(const std::filesystem::path& file);

}  // namespace plumb
