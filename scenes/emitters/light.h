#pragma once

#include <concepts>
#include <limits>
#include <optional>

#include "core/point.h"
#include "core/spectrum.h"
#include "core/vec3.h"
#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/geometry/ball.h"
#include "scenes/geometry/surface_point.h"

namespace plumb {

// Conventions of every light, held to by verification/suites/lights/ (scenes/sensors/sensor.h mirrors them):
//   everything is seen from a reference point `from`, in world space; directions are unit vectors that leave it;
//   radiance is what arrives at `from`, per lane, nothing in between; densities are per steradian at `from`;
//   a surface emits on the side its normal points to, and only the first point along a direction counts: a convex light
//   hides its far side;
//   a light that no ray can hit (a point) has Measure::discrete: its pdf is the probability 1, and `radiance` is the
//   irradiance on a plane that faces it. Either way  f(direction) cos θ radiance / pdf  estimates reflected radiance;
//   a light also sends rays of its own, as a sensor does: an origin, then a direction, each with its density. Surfaces
//   send them from every shining point alike, per area, by the cosine; points from where they are, with density 1;
//   environments, being nowhere, from the disk that touches a ball around the scene and faces it: the direction first,
//   then the point of the disk, per area. The weight  L cos θ / (pdf_area · pdf_direction)  is the ray's flux.

/// The kinds of lights: with a surface that rays hit, a point, or all directions from afar.
enum class LightKind { surface, point, environment };

/// A direction in which light arrives at `from`, drawn by the light.
struct LightSample {
    Vec3 direction;
    double distance = std::numeric_limits<double>::infinity();  ///< infinite for environments
    Spectrum radiance;
    double pdf = 0;
    Measure measure = Measure::solid_angle;
    std::optional<SurfacePoint> surface = {};  ///< where a shadow ray ends; empty for environments and points
};

/// The point of the light that a ray from `from` meets.
struct LightHit {
    double distance = std::numeric_limits<double>::infinity();
    Spectrum radiance;
    double pdf = 0;  ///< of sample(from) for this very direction
};

/// The density of a ray that a light sends.
struct EmittedRayPdf {
    double area;       ///< of the origin, per area of the light or of an environment's disk; 1 for a point
    double direction;  ///< per steradian
};

/// A ray that a light sends.
struct EmittedRay {
    Vec3 origin, direction;  ///< unit, away from the light
    Spectrum weight;         ///< flux
    EmittedRayPdf pdf;
    std::optional<SurfacePoint> surface = {};  ///< that it leaves; its normal is on the shining side
};

template <class L>
concept LightModel = requires(const L& light, Vec3 from, Vec3 normal, Vec3 direction, const Point<2>& u,
                              const Point<2>& v, const Ball& scene) {
    { L::kind } -> std::convertible_to<LightKind>;
    /// An empty result means that this u shows no light (it fell on a side that does not shine): the sample's estimate
    /// is 0.
    { light.sample(from, u) } -> std::same_as<std::optional<LightSample>>;
    /// An empty result means that the ray meets no shining side. Discrete lights are never met.
    { light.hit(from, direction) } -> std::same_as<std::optional<LightHit>>;
    /// The flux into the scene, in watts; an environment's goes through the disk of the scene's radius, from every
    /// direction.
    { light.power(scene.radius) } -> std::same_as<Spectrum>;
    /// The ray that the light sends for u, which chooses the origin, and v, which chooses the direction.
    { light.sample_ray(scene, u, v) } -> std::same_as<EmittedRay>;
    /// The density with which the light sends rays along the unit `direction` from where its normal, on the shining
    /// side, is `normal`; points and environments have no normal.
    { light.ray_pdf(scene, normal, direction) } -> std::same_as<EmittedRayPdf>;
};

/// The density per steradian of a point chosen with a density per area of its surface, seen from a distance with |cos|
/// at the surface: dω = cos dA / d².
constexpr double per_steradian(double pdf_area, double distance, double cos_at_light) {
    return pdf_area * distance * distance / cos_at_light;
}

}  // namespace plumb
