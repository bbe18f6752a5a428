#pragma once

#include <array>

#include "scenes/description/mesh.h"
#include "scenes/description/models.h"

namespace plumb::description {

// These shapes are loaded as meshes, in world space.

struct ObjMesh {
    static constexpr std::array plugins{Plugin{"obj", "a mesh from a Wavefront file"}};
    static Mesh load(Properties& properties);
};

struct PlyMesh {
    static constexpr std::array plugins{Plugin{"ply", "a mesh from a PLY file, of text or binary"}};
    static Mesh load(Properties& properties);
};

struct RectangleMesh {
    static constexpr std::array plugins{Plugin{"rectangle", "[-1,1]^2 at z = 0"}};
    static Mesh load(Properties& properties);
};

struct CubeMesh {
    static constexpr std::array plugins{Plugin{"cube", "[-1,1]^3"}};
    static Mesh load(Properties& properties);
};

}  // namespace plumb::description
