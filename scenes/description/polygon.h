#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scenes/description/mesh.h"

namespace plumb {

/// Adds a flat face with these corners, indices of the mesh's vertices in their order around it, as triangles that
/// cover it once and turn as it does. They are the fan from the first corner where that corner sees the whole face, as
/// it does in convex ones; else ears are cut off in the corners' order [Meisters 1975]. What is inside is decided
/// exactly, for the face seen along the axis that it faces most. Returns what is wrong with a face whose edges cross
/// or touch, as they do around a hole, and then adds nothing; empty where all is well. A face without area is a fan.
std::string add_polygon(Mesh& mesh, std::span<const std::uint32_t> corners);

}  // namespace plumb
