#pragma once

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/fresnel.h"

namespace plumb {

/// A smooth coat and what it sends back of a diffuse base's light; one a material.
struct SmoothCoat {
    explicit SmoothCoat(double index) : eta(index), returned(mean_fresnel_dielectric(1 / index)) {}
    double eta;       ///< its index over that outside, > 1
    double returned;  ///< the share of the base's light that it reflects back
};

/// A diffuse base under a smooth dielectric coat, with all the light that the coat throws back onto the base
/// [Mitsuba's plastic]. Black below.
struct Plastic {
    /// nonlinear: the base colours each of its reflections, not only the first.
    Plastic(const Spectrum& diffuse_reflectance, const SmoothCoat& coat, bool nonlinear);

    Spectrum diffuse_reflectance;
    Spectrum specular_reflectance = Spectrum::grey(1);  ///< a factor of no physics
    double eta;

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport) const;
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport) const;
    [[nodiscard]] double discrete(Vec3 wo) const { return wo.z > 0 ? mirror_probability(wo.z) : 0; }

private:
    [[nodiscard]] double mirror_probability(double cos_o) const;

    Spectrum base_;        // of the base with all internal reflections, times 1/eta²
    double mirror_share_;  // of the coat in the sampling, against the base's
};

static_assert(BsdfModel<Plastic>);

/// ρ/(1 − ρ r), or ρ/(1 − r) when only the first reflection is coloured: the light that leaves a base of reflectance ρ
/// under a coat that returns the share r of it.
Spectrum interreflected(const Spectrum& reflectance, double returned, bool nonlinear);

}  // namespace plumb
