#pragma once

#include <concepts>
#include <limits>
#include <optional>

#include "core/point.h"
#include "core/spectrum.h"
#include "core/vec3.h"
#include "scenes/bsdf_model.h"
#include "scenes/surface_point.h"

namespace plumb {

// Conventions of every emitter, held to by verification/suites/light*.cpp (scenes/sensors/sensor.h mirrors them):
//   everything is seen from a reference point `from`, in world space; directions are unit vectors that leave it;
//   radiance is what arrives at `from`, per lane, nothing in between; densities are per steradian at `from`;
//   a surface emits on the side its normal points to, and only the first point along a direction counts: a convex light
//   hides its far side;
//   a light that no ray can hit (a point) has Measure::discrete: its pdf is the probability 1, and `radiance` is the
//   irradiance on a plane that faces it. Either way  f(direction) cos θ radiance / pdf  estimates reflected radiance.

struct EmitterSample {
    Vec3 direction;
    double distance = std::numeric_limits<double>::infinity();  ///< infinite for environments
    Spectrum radiance;
    double pdf = 0;
    Measure measure = Measure::solid_angle;
    std::optional<SurfacePoint> surface = {};  ///< where a shadow ray ends; empty for environments and points
};

/// What a ray from `from` meets of the light.
struct EmitterHit {
    double distance = std::numeric_limits<double>::infinity();
    Spectrum radiance;
    double pdf = 0;  ///< of sample(from) for this very direction
};

template <class E>
concept EmitterModel = requires(const E& emitter, Vec3 from, Vec3 direction, const Point<2>& u, double scene_radius) {
    /// Empty: this u shows no light (it fell on a side that does not shine); the sample's estimate is 0.
    { emitter.sample(from, u) } -> std::same_as<std::optional<EmitterSample>>;
    /// Empty: the ray meets no shining side. Discrete lights are never met.
    { emitter.hit(from, direction) } -> std::same_as<std::optional<EmitterHit>>;
    /// Flux into the scene: watts, of an environment through the disk of the scene's radius, from every direction.
    { emitter.power(scene_radius) } -> std::same_as<Spectrum>;
};

/// A density per area of a surface, seen from a distance with |cos| at the surface, per steradian: dω = cos dA / d².
constexpr double per_steradian(double pdf_area, double distance, double cos_at_light) {
    return pdf_area * distance * distance / cos_at_light;
}

}  // namespace plumb
