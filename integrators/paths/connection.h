#pragma once

#include "integrators/paths/shift.h"

namespace plumb {

// An edge by which a shifted path is joined to the vertices that it shares with its base: from a vertex z_k to the
// vertex z_{k+1} that is kept, or to the environment, where the direction is kept.

/// The edges that may be such: short ones and those of narrow lobes make Jacobians that nobody can use.
struct ConnectionLimits {
    double roughness;  ///< at both ends, of the whole smooth part (smooth_roughness); the environment is rough
    double distance;   ///< in the scene's unit; the environment is far
};
/// The limits for a scene: roughness 0.2, and 2 % of the scene's diameter.
ConnectionLimits connection_limits(const Scene& scene);

/// The reason why there is no connection between two vertices, whatever is in its way; `to` is null for the
/// environment.
ShiftFailure connection_failure(const ConnectionLimits& limits, const PathVertex& from, const PathVertex* to);
using ConnectionFailure = ShiftFailure (*)(const ConnectionLimits& limits, const PathVertex& from,
                                           const PathVertex* to);

/// An edge between two vertices' positions, not along the rays that were traced: rays start beside surfaces, and the
/// density must be the same there and back.
struct Connection {
    Vec3 direction;         ///< from z_k, unit
    double pdf = 0;         ///< of the direction at z_k, per steradian, of the smooth part; 0 where nothing scatters
    double cos = 1;         ///< |cos| at z_{k+1}, about the geometric normal; 1 of the environment
    double distance = 1;    ///< 1 of the environment
    double pdf_beyond = 0;  ///< of the next direction at z_{k+1}, likewise; 0 where there is none
    std::optional<PathVertex> end = {};  ///< z_{k+1} as seen from z_k; empty: the environment
};

/// The edge from a vertex to a surface.
Connection connection_to(const Scene& scene, const PathVertex& from, const Hit& to);
/// The edge to the environment in a direction.
Connection connection_to_environment(const PathVertex& from, Vec3 direction);

/// The density of the smooth part in a direction that light may come from: 0 where the normals disagree about its side.
double smooth_pdf(const PathVertex& vertex, Vec3 wi);

/// The density of the edge's far end: per unit area at z_{k+1}, or per steradian for the environment.
double connection_density(const Connection& connection);
/// The density with which the path goes on at z_{k+1}, per steradian.
double density_beyond(const Connection& connection);
using ConnectionDensity = double (*)(const Connection& connection);

/// Whether a ray along the edge ends at its far end; at masks the number u decides that decided for the base path.
bool reaches(const Scene& scene, const PathVertex& from, const Connection& connection, double u, RayLog& rays);

}  // namespace plumb
