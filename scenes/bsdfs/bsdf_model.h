#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string_view>

#include "core/spectrum.h"
#include "core/vec3.h"

namespace plumb {

// Conventions of every closure, held to by verification/suites/surfaces/ and by check_bsdf for anybody's model:
//   directions are unit vectors in the shading frame, z along the normal, both leaving the surface;
//   wo is given, wi is chosen; z > 0 is outside (the side of the exterior index), a closure handles both signs of wo.z;
//   eval() is f(wo, wi)·|wi.z|, pdf() is per steradian of wi; both describe the smooth part only: mirrors and smooth
//   interfaces speak through sample();
//   a refracted sample's radiance scales by 1/eta² (Transport::radiance), importance does not (Transport::importance),
//   so that eval(wo, wi, radiance)/|wi.z| = eval(wi, wo, importance)/|wo.z|;
//   u[0] chooses the lobe, (u[1], u[2]) the direction in it: for a given lobe the map to wi is smooth but for cuts;
//   ∫ pdf + discrete + lost = 1, where lost is the probability of an empty sample;
//   everything is lane by lane in Spectrum; a closure is a small value of numbers (textures are resolved before).

/// The quantity that a path carries: radiance on its way from the sensor, importance on its way from a light.
enum class Transport { radiance, importance };
/// The measure of a density: per steradian, or a probability where directions are discrete.
enum class Measure { solid_angle, discrete };

/// The mirror image of wo at the plane z = 0.
constexpr Vec3 mirrored(Vec3 wo) {
    return {-wo.x, -wo.y, wo.z};
}
/// The mirror image of wo at the plane that the unit vector m is normal to.
constexpr Vec3 mirrored(Vec3 wo, Vec3 m) {
    return 2 * dot(wo, m) * m - wo;
}
constexpr bool same_side(Vec3 a, Vec3 b) {
    return a.z * b.z > 0;
}

/// A direction that a closure draws for given wo.
struct BsdfSample {
    Vec3 wi;
    Spectrum weight;  ///< eval / pdf for a smooth lobe, reflectance or transmittance / probability for a discrete one
    double pdf;       ///< per steradian, or a probability, as measure says
    Measure measure;
    double eta = 1;    ///< index on wi's side over index on wo's side: 1 for reflection
    double roughness;  ///< of the lobe that was sampled: 0 for a mirror, 1 for a diffuse one
};

template <class B>
concept BsdfModel = requires(const B& bsdf, Vec3 wo, Vec3 wi, const std::array<double, 3>& u, Transport transport) {
    { bsdf.eval(wo, wi, transport) } -> std::same_as<Spectrum>;
    { bsdf.pdf(wo, wi) } -> std::same_as<double>;
    /// An empty result means that nothing scatters: the sample is lost, and its estimate is 0.
    { bsdf.sample(wo, u, transport) } -> std::same_as<std::optional<BsdfSample>>;
    /// The probability that sample(wo) takes a discrete lobe.
    { bsdf.discrete(wo) } -> std::same_as<double>;
};

/// A model that is one of ours, and so says what it is.
template <class B>
concept NamedBsdfModel = BsdfModel<B> && requires(const B& bsdf) {
    { B::name } -> std::convertible_to<std::string_view>;
    /// Whether it has a smooth part: a surface of mirrors alone needs no sample of a light.
    { B::smooth } -> std::convertible_to<bool>;
    /// The colour that a denoiser or a person takes for the surface's: the reflectance of what scatters, grey 1 for
    /// glass.
    { bsdf.albedo() } -> std::same_as<Spectrum>;
    /// The least roughness of the lobes of the smooth part, as a BsdfSample states it of one lobe: 1 for a diffuse one,
    /// 0 where there is no smooth part.
    { bsdf.roughness() } -> std::same_as<double>;
};

}  // namespace plumb
