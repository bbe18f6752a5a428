#pragma once

#include <array>

#include "scenes/description/mesh.h"
#include "scenes/description/models.h"

namespace plumb {

/// |x| + |y| + |z| = 1, facing outwards.
Mesh octahedron_mesh();

namespace description {

struct OctahedronMesh {
    static constexpr std::array plugins{Plugin{"octahedron", "|x| + |y| + |z| = 1"}};
    static Mesh load(Properties& properties);
};

}  // namespace description

}  // namespace plumb
