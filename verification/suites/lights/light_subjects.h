#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenes/emitters/environment_map.h"
#include "scenes/emitters/light.h"

namespace plumb::suites {

/// A light on trial, with what is known of it by hand.
struct Light {
    std::string name, title, source;
    std::function<std::optional<LightSample>(Vec3 from, const Point<2>& u)> sample;
    std::function<std::optional<LightHit>(Vec3 from, Vec3 direction)> hit;
    std::function<Spectrum(double)> power;
    std::function<EmittedRay(const Ball& scene, const Point<2>& u, const Point<2>& v)> sample_ray;
    std::function<EmittedRayPdf(const Ball& scene, Vec3 normal, Vec3 direction)> ray_pdf;
    double largest_pdf = 0;      ///< as seen from the origin
    double reference_power = 0;  ///< in the second lane, for a scene of the enclosing radius
    Vec3 centre{};               ///< of a sphere around the light
    double enclosing = 1;
    double largest_flux = 0;  ///< bound of area · L cos θ / pdf over that sphere
    std::string pdf_defect;
    /// The density of a sample or hit that has this defect.
    std::function<double(Vec3 from, Vec3 direction, double distance, double pdf)> wrong_pdf;
    bool hits = true;
    bool infinite = false;  ///< around what it shines on, instead of within
    bool uniform = false;   ///< the same density in all directions

    [[nodiscard]] Light with_wrong_pdf() const;
};

/// One light of each kind. All but the point are seen from the origin.
std::vector<Light> lights();

/// The environment map among them, of 8 × 4 pixels, turned by environment_frame().
const EnvironmentMap& environment_map();
const Frame& environment_frame();

}  // namespace plumb::suites
