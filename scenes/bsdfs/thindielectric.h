#pragma once

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/material.h"

namespace plumb {

/// A pane between two parallel interfaces, too near to each other to shift what passes. The mirrored direction is drawn
/// with the probability of all that the pane reflects, over all reflections within it.
struct ThinDielectric {
    static constexpr std::string_view name = "thindielectric";
    static constexpr bool smooth = false;

    double eta = 1.5;  ///< index of the pane over that around it
    Spectrum reflectance = Spectrum::grey(1), transmittance = Spectrum::grey(1);  ///< factors of no physics

    [[nodiscard]] Spectrum eval(Vec3, Vec3, Transport) const { return {}; }
    [[nodiscard]] double pdf(Vec3, Vec3) const { return 0; }
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport transport) const;
    [[nodiscard]] double discrete(Vec3 wo) const { return wo.z != 0 ? 1 : 0; }
    [[nodiscard]] Spectrum albedo() const { return Spectrum::grey(1); }
    [[nodiscard]] double roughness() const { return 0; }
};

static_assert(NamedBsdfModel<ThinDielectric>);

/// The share of light under cos_i in [0, 1] that a pane of two interfaces reflects, eta its index over that around it.
double pane_reflectance(double cos_i, double eta);

namespace description {

/// A pane, as of a window, without a thickness of its own.
struct ThinDielectric {
    double eta = 1.5046 / 1.000277;  ///< index of the pane over that around it
    Colour specular_reflectance = Spectrum::grey(1), specular_transmittance = Spectrum::grey(1);

    using Closures = Types<plumb::ThinDielectric>;
    static constexpr std::array plugins{
        Plugin{"thindielectric", "a pane without thickness, as of a window: reflects and lets through"}};
    static constexpr bool only_reflects = false;
    static ThinDielectric load(Properties& properties);
    [[nodiscard]] Scatters scatters() const { return {false, true}; }
    [[nodiscard]] Bsdf at(const Lookup& lookup) const;
};

static_assert(MaterialModel<ThinDielectric>);

}  // namespace description

}  // namespace plumb
