#pragma once

#include <optional>

#include "integrators/paths/path_story.h"

namespace plumb {

/// The paths that are estimated. Edges count from the sensor: 1 is a light seen directly, 2 direct light.
struct PathLimits {
    int max_edges = -1;                     ///< longer paths count as black; -1: none is too long
    int roulette_edges = 5;                 ///< paths of as many edges may end by Russian roulette
    int length = 0;                         ///< only paths of so many edges; 0: of all
    std::optional<Strategy> strategy = {};  ///< of `bdpt`: this one alone, unweighted

    [[nodiscard]] bool allow(int edges) const { return max_edges < 0 || edges <= max_edges; }
};

/// The largest number of a vertex in the slots of one subpath; a path of so many edges carries nothing that a double
/// can tell.
constexpr int last_vertex = 0x7ff0;

/// The probability with which a path goes on: what it carries, made comparable across interfaces by eta² of the medium
/// that it is in, which compresses radiance without any light being lost [Veach 1997, section 5.2].
using Survival = double (*)(const Spectrum& throughput, double eta_squared);
double survive_by_throughput(const Spectrum& throughput, double eta_squared);

}  // namespace plumb
