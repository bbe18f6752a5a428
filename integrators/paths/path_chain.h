#pragma once

#include <span>

#include "integrators/paths/subpath.h"

namespace plumb {

/// A whole path z_0 … z_n, from the sensor to the light, as strategies see it. Strategy t makes its first t vertices
/// from the sensor and the other s = n + 1 − t from the light, with the density
///   p_t = ∏_{i<t} from_camera[i] ∏_{i≥t} from_light[i],
/// except that for s = 1 the light is sampled from the vertex before: `choice` takes the place of from_light[n] [Veach
/// 1997, section 10.2].
struct PathChain {
    std::vector<const SubpathVertex*> vertices;
    std::vector<double> from_camera, from_light;  ///< of each vertex; those of the sensor are not used
    std::vector<char> discrete;                   ///< whether it scatters by a mirror: then nothing connects to it
    double choice = 0;

    [[nodiscard]] int edges() const { return static_cast<int>(vertices.size()) - 1; }
};

/// Joins the first t vertices of a subpath from the sensor and the first s of one from a light to a path. The subpaths
/// must outlive it. `choice` samples the lights.
void join(const Scene& scene, const LightChoice& choice, std::span<const SubpathVertex> camera,
          std::span<const SubpathVertex> light, PerArea per_area, PathChain& chain);

/// Whether strategy t can make the path.
bool can_make(const PathChain& chain, int t);

/// The weight of strategy t by the power heuristic [Veach 1997, eq. 9.13], from ratios of densities. The weights of all
/// strategies that can make the path sum to 1.
double strategy_weight(const PathChain& chain, int t);

}  // namespace plumb
