#pragma once

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/microfacet.h"

namespace plumb {

/// A rough metal [Cook & Torrance 1982; Walter et al. 2007]: facets that are smooth conductors, one scattering each. It
/// samples visible normals; a sample whose direction falls below the surface is lost. It is black below.
struct RoughConductor {
    static constexpr std::string_view name = "roughconductor";
    static constexpr bool smooth = true;

    Microfacets facets;
    Spectrum eta, k = Spectrum::grey(1);
    Spectrum reflectance = Spectrum::grey(1);

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport) const;
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport) const;
    [[nodiscard]] double discrete(Vec3) const { return 0; }
    /// The reflectance at normal incidence.
    [[nodiscard]] Spectrum albedo() const;
    [[nodiscard]] double roughness() const { return facets.alpha; }
};

static_assert(NamedBsdfModel<RoughConductor>);

}  // namespace plumb
