#include "scenes/geometry/mesh_shapes.h"

#include <fmt/format.h>

#include <cmath>

#include "scenes/description/obj.h"
#include "scenes/description/ply.h"

namespace plumb::description {

namespace {

// Finite in its file, a vertex may still be no float after its transform.
void check_finite(const Mesh& mesh, const Place& place) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (const float x : mesh.positions[i]) {
            if (!std::isfinite(x))
                throw place.error(fmt::format("vertex {} has the coordinate {}; finite floats are accepted", i, x));
        }
    }
}

Mesh placed(Mesh mesh, Properties& properties) {
    if (properties.boolean("flip_normals", false)) flip_normals(mesh);
    mesh = transformed(std::move(mesh), properties.transform("to_world"));
    check_finite(mesh, properties.place());
    return mesh;
}

/// What a file's mesh is with the properties that all formats share. `turned`: the format's v grows upwards, and the
/// reader has turned it.
Mesh finished(Mesh mesh, Properties& properties, bool turned) {
    if (properties.boolean("flip_tex_coords", turned) != turned) {
        for (auto& uv : mesh.uvs) uv[1] = 1 - uv[1];
    }
    if (properties.boolean("face_normals", false)) {
        mesh.normals.clear();
    } else if (mesh.normals.empty()) {
        add_smooth_normals(mesh);
    }
    return placed(std::move(mesh), properties);
}

}  // namespace

Mesh ObjMesh::load(Properties& properties) {
    return finished(read_obj(properties.file("filename")), properties, true);
}

Mesh PlyMesh::load(Properties& properties) {
    return finished(read_ply(properties.file("filename")), properties, false);
}

Mesh RectangleMesh::load(Properties& properties) {
    return placed(rectangle_mesh(), properties);
}

Mesh CubeMesh::load(Properties& properties) {
    return placed(cube_mesh(), properties);
}

}  // namespace plumb::description
