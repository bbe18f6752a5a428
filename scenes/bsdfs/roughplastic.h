#pragma once

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/rough_transmittance.h"

namespace plumb {

/// A diffuse base under a rough dielectric coat, with all the light that the coat throws back onto the base [Mitsuba's
/// roughplastic]. The coat lets in what it does not reflect, so that a white base loses nothing but its table's error,
/// less than 1e-3. It is black below.
struct RoughPlastic {
    static constexpr std::string_view name = "roughplastic";
    static constexpr bool smooth = true;

    /// The coat's table, one for each material, must outlive the closure.
    RoughPlastic(const Spectrum& diffuse_reflectance, const RoughTransmittance& coat, bool nonlinear);

    Spectrum diffuse_reflectance;
    Spectrum specular_reflectance = Spectrum::grey(1);  ///< a factor of no physics

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport) const;
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const;
    [[nodiscard]] double discrete(Vec3) const { return 0; }
    [[nodiscard]] Spectrum albedo() const { return diffuse_reflectance; }
    [[nodiscard]] double roughness() const { return coat_->facets().alpha; }

private:
    [[nodiscard]] double coat_probability(double cos_o) const;

    const RoughTransmittance* coat_;
    Spectrum base_;      // of the base with all internal reflections, times 1/eta²
    double coat_share_;  // of the coat in the sampling, against the base's
};

static_assert(NamedBsdfModel<RoughPlastic>);

}  // namespace plumb
