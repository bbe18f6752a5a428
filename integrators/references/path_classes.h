#pragma once

#include <compare>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace plumb {

/// A class of paths of which an integrator can make all or none. The lens, pinhole or not, is on no surface: nothing
/// hits it.
struct PathClass {
    using Source = LightKind;

    std::vector<bool> mirrors;  ///< of each surface vertex from the sensor on, whether a mirror or smooth interface
                                ///< scatters there (their directions have no density), or the rest of a material
    Source source;

    [[nodiscard]] int edges() const { return static_cast<int>(mirrors.size()) + 1; }
    friend auto operator<=>(const PathClass&, const PathClass&) = default;
};

/// The class in the notation of light transport, from the eye: "ESDL"; L is a surface, P a point, V the environment.
std::string to_string(const PathClass& path);

/// All classes of so many edges that the scene's materials and lights can be combined into, wherever they stand.
std::vector<PathClass> path_classes(const Scene& scene, int edges);

/// Whether an integrator makes paths of this class.
using MakesPath = bool (*)(const PathClass& path);

/// `path` meets a light, or samples one from a vertex that is no mirror.
bool path_makes(const PathClass& path);
/// `light` connects a vertex that is no mirror to the lens, and sees lights directly.
bool light_makes(const PathClass& path);
/// `bdpt` does what `path` or `light` does, or connects two vertices that are no mirrors.
bool bdpt_makes(const PathClass& path);
/// `direct` and its kind do what `path` does in two edges: by samples of BSDFs they meet lights, by samples of lights
/// they light a vertex that is no mirror. All see lights directly.
bool direct_makes(const PathClass& path);
bool direct_bsdf_makes(const PathClass& path);
bool direct_emitters_makes(const PathClass& path);

/// The classes of at most so many edges that `bdpt` makes in the scene and this integrator does not.
std::vector<PathClass> left_out(MakesPath makes, const Scene& scene, int most_edges);

}  // namespace plumb
