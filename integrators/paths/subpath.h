#pragma once

#include "integrators/paths/light_start.h"
#include "integrators/paths/limits.h"
#include "integrators/paths/next_event/light_choice.h"

namespace plumb {

// Subpaths from the sensor and from a light, and the densities that multiple importance sampling of their connections
// asks for. A density is per area of the vertex that is found; per steradian for the environment; and for the vertex
// after an environment, whose rays come from a disk, per area of that disk times the cosine. Densities of the sensor
// are for a film that is sampled evenly, once for each light subpath: 1/pixels per pixel².

/// A vertex of a subpath.
struct SubpathVertex {
    enum class Kind { sensor, surface, light, point_light, environment };

    Kind kind;
    SurfacePoint point;  ///< normals of lights on the shining side, 0 where there is none; the position of the
                         ///< environment is the unit direction towards it
    std::optional<std::size_t> light;  ///< that the vertex is a part of
    std::optional<PathVertex> surface;
    Spectrum throughput = Spectrum::grey(1);  ///< with which the subpath arrives
    double pdf = 1;                           ///< with which its subpath found it
    double drawn = 1;                         ///< density of the numbers that it depends on: 1 unless guided
    double pdf_back = 0;    ///< with which another would have, from the next vertex; known once there are two
    bool discrete = false;  ///< a mirror, or a smooth interface, sent the subpath on

    [[nodiscard]] Vec3 position() const { return point.position; }
    [[nodiscard]] Vec3 normal() const { return point.normal; }
    [[nodiscard]] Vec3 towards(const SubpathVertex& other) const;
};
using Subpath = std::vector<SubpathVertex>;

/// The density per area at `to` of what leaves `from` with the density pdf per steradian: dω → dA.
double per_area(double pdf, const SubpathVertex& from, const SubpathVertex& to);
using PerArea = double (*)(double pdf, const SubpathVertex& from, const SubpathVertex& to);

/// The falloff 1/d²: with the cosines, which scattering contains, it turns dω into dA between two surfaces that see
/// each other.
inline double falloff(const SubpathVertex& x, const SubpathVertex& y) {
    return 1 / length_squared(y.position() - x.position());
}
using Falloff = double (*)(const SubpathVertex& x, const SubpathVertex& y);

/// The rules by which subpaths grow and meet: functions, so that a claim can put others in their place.
struct SubpathRules {
    PathLimits limits;
    Survival survival = survive_by_throughput;
    ShadingCorrection correction = shading_correction;
    PerArea per_area = plumb::per_area;
    Falloff falloff = plumb::falloff;
    /// The quantity that a subpath from either end carries.
    Transport from_camera = Transport::radiance, from_light = Transport::importance;
};

/// The density with which light or importance that reaches `at` from `before` goes on to `next`; `before` is null where
/// a subpath begins: at the sensor, or at a vertex of a light.
double density_onwards(const Scene& scene, const SubpathVertex* before, const SubpathVertex& at,
                       const SubpathVertex& next, PerArea per_area);
/// The density with which a light's subpath begins at the vertex and goes on towards `next`: of its first vertex alone.
double density_of_origin(const Scene& scene, const SubpathVertex& light, const SubpathVertex& next);
/// The density with which a choice samples a light from a surface.
double density_of_choice(const Scene& scene, const LightChoice& choice, const SubpathVertex& light,
                         const SubpathVertex& from, PerArea per_area);

/// The subpath from the sensor: the sensor, surfaces, and the environment where the subpath leaves the scene.
Subpath camera_subpath(const Scene& scene, const CameraStart& start, const SubpathRules& rules, Draws& draws,
                       PathRecord& record);
/// The subpath from a light: a vertex of the light, and surfaces. It is empty in a scene without lights.
Subpath light_subpath(const Scene& scene, const SubpathRules& rules, Draws& draws, PathRecord& record);

SubpathVertex sensor_vertex(Vec3 position);
/// The vertex of a light that a choice found from there.
SubpathVertex light_vertex(const Scene& scene, Vec3 from, const SceneLightSample& sample);

}  // namespace plumb
