#pragma once

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/material.h"
#include "scenes/bsdfs/roughdielectric.h"
#include "scenes/bsdfs/roughness.h"

namespace plumb {

/// A smooth interface between two media. The mirrored direction is drawn with probability Fresnel's reflectance.
struct Dielectric {
    static constexpr std::string_view name = "dielectric";
    static constexpr bool smooth = false;

    double eta = 1.5;                                                             ///< index inside over index outside
    Spectrum reflectance = Spectrum::grey(1), transmittance = Spectrum::grey(1);  ///< factors of no physics

    [[nodiscard]] Spectrum eval(Vec3, Vec3, Transport) const { return {}; }
    [[nodiscard]] double pdf(Vec3, Vec3) const { return 0; }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const;
    [[nodiscard]] double discrete(Vec3 wo) const { return wo.z != 0 ? 1 : 0; }
    [[nodiscard]] Spectrum albedo() const { return Spectrum::grey(1); }
    [[nodiscard]] double roughness() const { return 0; }
};

static_assert(NamedBsdfModel<Dielectric>);

namespace description {

/// An interface between two media.
struct Dielectric {
    double eta = 1.5046 / 1.000277;  ///< index inside over index outside
    Colour specular_reflectance = Spectrum::grey(1), specular_transmittance = Spectrum::grey(1);
    std::optional<Roughness> roughness;

    using Closures = Types<plumb::Dielectric, RoughDielectric>;
    static constexpr std::array plugins{
        Plugin{"dielectric", "a smooth interface, as of glass: reflects and refracts"},
        Plugin{"roughdielectric", "a rough interface: Beckmann or GGX microfacets, visible normals"}};
    static constexpr bool only_reflects = false;
    static Dielectric load(Properties& properties);
    [[nodiscard]] Scatters scatters() const { return {roughness.has_value(), !roughness}; }
    [[nodiscard]] Bsdf at(const Lookup& lookup) const;
};

static_assert(MaterialModel<Dielectric>);

}  // namespace description

}  // namespace plumb
