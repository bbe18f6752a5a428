#pragma once

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/microfacet.h"

namespace plumb {

/// A rough interface between two media [Walter et al. 2007]: facets that are smooth dielectrics, one scattering each.
/// It samples a visible normal, then reflects or refracts at it by Fresnel's reflectance; a sample that ends on the
/// wrong side is lost. eta must not be 1: without contrast nothing scatters, and the half vector of refraction has no
/// length.
struct RoughDielectric {
    static constexpr std::string_view name = "roughdielectric";
    static constexpr bool smooth = true;

    Microfacets facets;
    double eta = 1.5;                                                             ///< index inside over index outside
    Spectrum reflectance = Spectrum::grey(1), transmittance = Spectrum::grey(1);  ///< factors of no physics

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport transport) const;
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const;
    [[nodiscard]] double discrete(Vec3) const { return 0; }
    [[nodiscard]] Spectrum albedo() const { return Spectrum::grey(1); }
    [[nodiscard]] double roughness() const { return facets.alpha; }
    /// The index on wi's side over the index on wo's side.
    [[nodiscard]] double eta_between(Vec3 wo, Vec3 wi) const {
        return same_side(wo, wi) ? 1 : wo.z > 0 ? eta : 1 / eta;
    }
};

static_assert(NamedBsdfModel<RoughDielectric>);

}  // namespace plumb
