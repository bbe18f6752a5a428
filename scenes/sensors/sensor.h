#pragma once

#include <concepts>
#include <optional>

#include "core/point.h"
#include "core/vec3.h"
#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/geometry/ray.h"

namespace plumb {

// Conventions of every sensor, held to by verification/suites/film/cameras.cpp. A sensor mirrors a light
// (scenes/emitters/light.h) with importance W for radiance:
//   film points are in pixels, x right and y down, pixel (i, j) covers [i, i+1) × [j, j+1), its centre is at + ½;
//   a pixel is I = ∫ h(p) L(ray(p, lens)) dp dlens: p per pixel², h the filter (of integral 1), lens uniform. So the
//   weight of a ray is 1, and pixels do not change when the film gets more of them;
//   pdf() is the density per steradian of the ray's direction when p has density 1 per pixel² everywhere;
//   I = ∫ h W cos θ L dω dA with dA on the lens and θ at the lens: W = pdf / (lens area · cos θ). Seen from a point in
//   the scene, importance arrives from the lens as radiance arrives from a light, with densities per steradian there.
//   A pinhole cannot be hit: Measure::discrete, pdf 1, and `importance` is that on a plane that faces it, W cos θ
//   (lens area)/d² in the limit.

/// A point of the lens as it is seen from a reference point in the scene.
struct SensorSample {
    Point<2> film;   ///< where the ray through the lens point would start
    Vec3 direction;  ///< unit, from the reference point to the lens
    double distance = 0;
    double importance = 0;
    double pdf = 0;
    Measure measure = Measure::solid_angle;
};

template <class S>
concept SensorModel = requires(const S& sensor, const Point<2>& film, const Point<2>& lens, Vec3 from, const Ray& ray) {
    /// The ray that enters the scene; lens is uniform on [0,1)².
    { sensor.sample_ray(film, lens) } -> std::same_as<Ray>;
    /// The density per steradian of the ray's direction, for its origin on the lens; 0 outside the film.
    { sensor.pdf(ray) } -> std::same_as<double>;
    /// An empty result means that the sensor does not see `from` through this lens point.
    { sensor.connect(from, lens) } -> std::same_as<std::optional<SensorSample>>;
};

}  // namespace plumb
