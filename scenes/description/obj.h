#pragma once

#include <filesystem>

#include "scenes/description/mesh.h"

namespace plumb {

/// Reads a Wavefront OBJ: v, vt, vn and f, with faces by add_polygon() and negative indices that count back; a
/// backslash at a line's end joins it to the next. Groups, materials, points and lines are skipped, as a scene's
/// materials come from the scene. v of vt becomes 1 − v, as v grows downwards here. In a mesh of which some corners
/// have uvs, the others have (0, 0) of the file; where some have normals, the others have those that
/// add_smooth_normals() gives the faces without. Throws Error with file and line.
Mesh read_obj(const std::filesystem::path& file);

}  // namespace plumb
