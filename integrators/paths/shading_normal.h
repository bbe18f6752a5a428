#pragma once

#include "integrators/paths/path_estimator.h"

namespace plumb {

/// The factor that corrects f |cos| at a vertex of a light's subpath, where cosines are about the shading normal. Light
/// arrives through |wo·ng| of area and is reflected as if through |wo·ns|; it leaves through |wi·ng|, not |wi·ns|
/// [Veach 1997, eq. 5.19]. The factor is 1 where both normals are one, and unbounded at grazing angles.
inline double shading_correction(const PathVertex& vertex, Vec3 wi) {
    const Vec3 ng = vertex.hit.point.normal, ns = vertex.frame.z;
    if (ng == ns) return 1;
    const double below = std::abs(dot(vertex.wo, ng) * dot(wi, ns));
    return below > 0 ? std::abs(dot(vertex.wo, ns) * dot(wi, ng)) / below : 0;
}

/// A correction for a light's subpath: a parameter, so that a claim can put others in its place.
using ShadingCorrection = double (*)(const PathVertex& vertex, Vec3 wi);

}  // namespace plumb
