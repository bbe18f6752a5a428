#include "scenes/emitters/rectangle_light.h"

#include <algorithm>

#include "scenes/emitters/mesh_light.h"

namespace plumb {

// Halves of one parallelogram have the edge from a to c in common, up to their starting corner.
std::optional<RectangleLight> RectangleLight::of(const Mesh& mesh, const Spectrum& radiance) {
    if (mesh.triangles.size() != 2) return {};
    const std::vector<Triangle> triangles = triangles_of(mesh);
    std::array<Vec3, 3> one{triangles[0].a, triangles[0].b, triangles[0].c};
    std::array<Vec3, 3> two{triangles[1].a, triangles[1].b, triangles[1].c};
    for (int i = 0; i < 3; ++i, std::ranges::rotate(one, one.begin() + 1))
        for (int j = 0; j < 3; ++j, std::ranges::rotate(two, two.begin() + 1))
            if (one[0] == two[0] && one[2] == two[1] && one[0] + one[2] == one[1] + two[2])
                return RectangleLight(one[0], one[1] - one[0], two[2] - one[0], radiance, mesh.largest_margin);
    return {};
}

}  // namespace plumb
