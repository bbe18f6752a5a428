#pragma once

#include <filesystem>

#include "scenes/description/mesh.h"

namespace plumb {

/// A Wavefront OBJ: v, vt, vn and f (polygons become fans, negative indices count back); groups and materials are
/// skipped, for a scene's materials come from the scene. v of vt becomes 1 − v, as v grows downwards here. A face
/// needs uvs (normals) on all its corners; a mesh has them when all its faces do. Throws Error with file and line.
Mesh read_obj(const std::filesystem::path& file);

}  // namespace plumb
