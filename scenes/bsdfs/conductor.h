#pragma once

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/material.h"
#include "scenes/bsdfs/roughconductor.h"
#include "scenes/bsdfs/roughness.h"

namespace plumb {

/// A smooth metal of index eta + i k relative to the outside: a mirror above, black below. eta = 0 reflects everything.
struct Conductor {
    static constexpr std::string_view name = "conductor";
    static constexpr bool smooth = false;

    Spectrum eta, k = Spectrum::grey(1);
    Spectrum reflectance = Spectrum::grey(1);  ///< a factor of no physics, which scene files use

    [[nodiscard]] Spectrum eval(Vec3, Vec3, Transport) const { return {}; }
    [[nodiscard]] double pdf(Vec3, Vec3) const { return 0; }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport) const;
    [[nodiscard]] double discrete(Vec3 wo) const { return wo.z > 0 ? 1 : 0; }
    /// The reflectance at normal incidence.
    [[nodiscard]] Spectrum albedo() const;
    [[nodiscard]] double roughness() const { return 0; }
};

static_assert(NamedBsdfModel<Conductor>);

namespace description {

/// A metal; a perfect mirror of reflectance 1 where `eta` is empty.
struct Conductor {
    std::optional<Spectrum> eta;  ///< real part of the index, relative to outside
    Spectrum k;                   ///< imaginary part
    Colour specular_reflectance = Spectrum::grey(1);
    std::optional<Roughness> roughness;

    using Closures = Types<plumb::Conductor, RoughConductor>;
    static constexpr std::array plugins{
        Plugin{"conductor", "a smooth metal by its complex index, or a perfect mirror"},
        Plugin{"roughconductor", "a rough metal: Beckmann or GGX microfacets, visible normals"}};
    static constexpr bool only_reflects = true;
    static Conductor load(Properties& properties);
    [[nodiscard]] Scatters scatters() const { return {roughness.has_value(), !roughness}; }
    [[nodiscard]] Bsdf at(const Lookup& lookup) const;
};

static_assert(MaterialModel<Conductor>);

}  // namespace description

}  // namespace plumb
