#include "scenes/geometry/octahedron.h"

namespace plumb {

Mesh octahedron_mesh() {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
        std::uint32_t x = octant & 1, y = 2 + (octant >> 1 & 1), z = 4 + (octant >> 2 & 1);
        const bool mirrored = ((octant ^ octant >> 1 ^ octant >> 2) & 1) == 1;  // an odd number of axes
        if (mirrored) std::swap(y, z);
        mesh.triangles.push_back({x, y, z});
    }
    return mesh;
}

namespace description {

Mesh OctahedronMesh::load(Properties& properties) {
    return transformed(octahedron_mesh(), properties.transform("to_world"));
}

}  // namespace description

}  // namespace plumb
