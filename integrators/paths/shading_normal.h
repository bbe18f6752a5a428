#pragma once

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// What f |cos| of a vertex on a light's subpath, with cosines about the shading normal, is to be multiplied by. Light
/// arrives through |wo·ng| of area and is reflected as if through |wo·ns|; it leaves through |wi·ng|, not |wi·ns|
/// [Veach 1997, eq. 5.19]. 1 where both normals are one; unbounded at grazing angles.
inline double shading_correction(const PathVertex& vertex, Vec3 wi) {
    const Vec3 ng = vertex.hit.point.normal, ns = vertex.frame.z;
    if (ng == ns) return 1;
    const double below = std::abs(dot(vertex.wo, ng) * dot(wi, ns));
    return below > 0 ? std::abs(dot(vertex.wo, ns) * dot(wi, ng)) / below : 0;
}

/// Of a light's subpath, as a function of its own so that a claim can put others in its place.
using ShadingCorrection = double (*)(const PathVertex& vertex, Vec3 wi);

}  // namespace plumb
