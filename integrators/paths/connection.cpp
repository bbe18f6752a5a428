#include "integrators/paths/connection.h"

#include "integrators/paths/vertex.h"

namespace plumb {

ConnectionLimits connection_limits(const Scene& scene) {
    return {.roughness = 0.2, .distance = 0.02 * 2 * scene.ball().radius};
}

ShiftFailure connection_failure(const ConnectionLimits& limits, const PathVertex& from, const PathVertex* to) {
    if (smooth_roughness(from.bsdf) < limits.roughness) return ShiftFailure::too_smooth;
    if (!to) return ShiftFailure::none;
    if (smooth_roughness(to->bsdf) < limits.roughness) return ShiftFailure::too_smooth;
    const double squared = length_squared(to->hit.point.position - from.hit.point.position);
    return squared < limits.distance * limits.distance ? ShiftFailure::too_near : ShiftFailure::none;
}

double smooth_pdf(const PathVertex& vertex, Vec3 wi) {
    if (!vertex.bsdf.smooth() || !vertex.lit(wi, Transport::radiance)) return 0;
    return vertex.bsdf.pdf(vertex.to_local(vertex.wo), vertex.to_local(wi));
}

Connection connection_to(const Scene& scene, const PathVertex& from, const Hit& to) {
    const Vec3 way = to.point.position - from.hit.point.position;
    Connection connection{.direction = normalize(way), .distance = length(way)};
    connection.pdf = smooth_pdf(from, connection.direction);
    connection.cos = std::abs(dot(to.point.normal, connection.direction));
    connection.end = vertex_at(scene, to, Ray{from.hit.point.position, connection.direction});
    return connection;
}

Connection connection_to_environment(const PathVertex& from, Vec3 direction) {
    return {.direction = direction, .pdf = smooth_pdf(from, direction)};
}

double connection_density(const Connection& connection) {
    return connection.pdf * connection.cos / (connection.distance * connection.distance);
}

double density_beyond(const Connection& connection) {
    return connection.pdf_beyond;
}

bool reaches(const Scene& scene, const PathVertex& from, const Connection& connection, double u, RayLog& rays) {
    LightSample edge{.direction = connection.direction, .radiance = {}};
    if (connection.end) {
        edge.distance = connection.distance;
        edge.surface = connection.end->hit.point;
    }
    const double passes = scene.transmittance(from.hit.point, edge, rays);
    if (!scene.has_masks()) return passes > 0;
    // A ray passes the surface i, of opacity o_i, if u ≥ o_i, and goes on with (u − o_i)/(1 − o_i): it passes all of
    // them if u ≥ 1 − ∏(1 − o_i), and is left with (u − 1 + ∏)/∏.
    const double stopped = 1 - passes;
    if (passes == 0 || u < stopped) return false;
    return !connection.end || (u - stopped) / passes < scene.opacity(connection.end->hit);
}

}  // namespace plumb
