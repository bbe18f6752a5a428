#pragma once

#include "integrators/path_estimator.h"

namespace plumb {

/// How a path that starts at the sensor begins: its film point, and the ray that enters the scene.
struct CameraStart {
    Point<2> film;
    Ray ray;
};
CameraStart start_at_camera(const Scene& scene, const FilmRegion& region, PrimarySamples& samples);

/// Where a ray meets the scene, at the vertex with this number (the sensor is 0); empty where it leaves it.
std::optional<Hit> trace_to_hit(const Scene& scene, const Ray& ray, std::uint16_t vertex, PrimarySamples& samples,
                                PathRecord& record);
/// With what scatters there.
std::optional<PathVertex> trace_to_vertex(const Scene& scene, const Ray& ray, std::uint16_t vertex,
                                          PrimarySamples& samples, PathRecord& record);

}  // namespace plumb
