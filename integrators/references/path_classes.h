#pragma once

#include <compare>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace plumb {

/// Paths that an integrator can make all or none of. The lens, pinhole or not, is on no surface: nothing hits it.
struct PathClass {
    using Source = EmitterKind;

    std::vector<bool> mirrors;  ///< of each surface vertex from the sensor on, whether a mirror or smooth interface
                                ///< scatters there (their directions have no density), or the rest of a material
    Source source;

    [[nodiscard]] int edges() const { return static_cast<int>(mirrors.size()) + 1; }
    friend auto operator<=>(const PathClass&, const PathClass&) = default;
};

/// In the notation of light transport, from the eye: "ESDL"; L is a surface, P a point, V the environment.
std::string to_string(const PathClass& path);

/// Every class of so many edges that the scene's materials and lights can be put together to, wherever they stand.
std::vector<PathClass> path_classes(const Scene& scene, int edges);

enum class Transporter { path, light, bdpt };
/// Whether it makes paths of this class. `path` meets a light, or samples one from a vertex that is no mirror; `light`
/// connects such a vertex to the lens, and sees lights directly; `bdpt` does either, or connects two such vertices.
bool can_make(Transporter transporter, const PathClass& path);
/// Classes of at most so many edges that `bdpt` makes in the scene, and this one does not.
std::vector<PathClass> left_out(Transporter transporter, const Scene& scene, int most_edges);

}  // namespace plumb
