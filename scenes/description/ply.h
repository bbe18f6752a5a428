#pragma once

#include <filesystem>

#include "scenes/description/mesh.h"

namespace plumb {

/// Reads a Stanford PLY, ASCII or binary of either byte order: vertices with x y z, if present nx ny nz and u v (or s
/// t), faces as lists vertex_indices or vertex_index (by add_polygon()), in any order of elements; all else is skipped.
/// Throws Error naming the file, the line (header and ASCII) or the vertex or face (binary), and the value found.
Mesh read_ply(const std::filesystem::path& file);

}  // namespace plumb
