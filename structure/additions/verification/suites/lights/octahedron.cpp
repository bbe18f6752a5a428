// A solid against what is known of it.

#include <cmath>

#include "scenes/geometry/octahedron.h"
#include "verification/claim.h"
#include "verification/evidence/deterministic.h"

namespace plumb::suites {
namespace {

/// By tetrahedra from the origin [divergence theorem]: negative where a face looks inwards.
double volume(const Mesh& mesh) {
    double sum = 0;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.corners(i);
        sum += dot(a, cross(b, c)) / 6;
    }
    return sum;
}

double area(const Mesh& mesh) {
    double sum = 0;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.corners(i);
        sum += length(cross(b - a, c - a)) / 2;
    }
    return sum;
}

Verdict is_octahedron(const Mesh& mesh) {
    return within_bound({{"area 4 sqrt 3", std::abs(area(mesh) - 4 * std::sqrt(3.0))},
                         {"volume 4/3", std::abs(volume(mesh) - 4.0 / 3)}},
                        1e-12, "absolute");
}

Mesh with_a_face_turned() {
    Mesh mesh = octahedron_mesh();
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    return mesh;
}

Mesh without_a_face() {
    Mesh mesh = octahedron_mesh();
    mesh.triangles.pop_back();
    return mesh;
}

}  // namespace

void add_lights_octahedron(Catalogue& catalogue) {
    catalogue.add({.id = "mesh/octahedron/size",
                   .statement = "The octahedron has the area 4 sqrt 3, and encloses 4/3 with its faces outwards.",
                   .source = "ours, scenes/geometry/octahedron.h",
                   .kind = Kind::bounded,
                   .trial = {is_octahedron,
                             octahedron_mesh(),
                             {{"turned", "a face looks inwards", with_a_face_turned()},
                              {"open", "a face is missing", without_a_face()}}}});
}

}  // namespace plumb::suites
