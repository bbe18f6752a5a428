#pragma once

#include <filesystem>

#include "scenes/description/mesh.h"

namespace plumb {

/// A Stanford PLY, ascii or binary of either byte order: vertices with x y z, if present nx ny nz and u v (or s t),
/// faces as lists vertex_indices or vertex_index (polygons become fans); all else is skipped. Throws Error naming the
/// file, the line (header and ascii) or the vertex or face (binary), and the value found.
Mesh read_ply(const std::filesystem::path& file);

}  // namespace plumb
