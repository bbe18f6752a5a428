#pragma once

#include "integrators/paths/shading_normal.h"
#include "integrators/paths/vertex.h"

namespace plumb {

/// The number of a light in the slots of its subpath, whose vertices follow it.
constexpr std::uint16_t first_light_vertex = 0x8000;

/// The beginning of a path at a light: the light's ray, as it is drawn and as it enters the scene.
struct LightStart {
    SceneLightRay light;
    Ray ray;
    double origin_density;  ///< of the numbers that chose the light and its point, without those of the direction
};
/// Draws the beginning of a light's subpath; empty without lights.
std::optional<LightStart> start_at_light(const Scene& scene, Draws& draws, const PathRecord& record);

/// A direction in which importance leaves a vertex of a light's subpath: sample_bsdf with the correction in its weight.
std::optional<ScatterSample> sample_importance(const PathVertex& vertex, std::uint16_t number, Draws& draws,
                                               ShadingCorrection correction, Transport carries = Transport::importance);

/// The lens (a pinhole is one) as seen from a point of the scene; empty where it is not seen.
using SensorConnection = std::optional<SensorSample> (*)(const Scene& scene, Vec3 from, const Point<2>& lens);
std::optional<SensorSample> connect_to_lens(const Scene& scene, Vec3 from, const Point<2>& lens);

/// The connection to a random point of the lens.
inline std::optional<SensorSample> sample_lens(const Scene& scene, Vec3 from, std::uint16_t number, Draws& draws,
                                               SensorConnection connect) {
    const bool lens = scene.sensor().has_lens();
    return connect(scene, from, lens ? Point<2>(draws.at({number, Use::lens})) : Point<2>{0.5, 0.5});
}
/// The lens as an end that Visibility is asked about.
LightSample end_at_lens(const SensorSample& sensor);

}  // namespace plumb
