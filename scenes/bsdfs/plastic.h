#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/fresnel.h"
#include "scenes/bsdfs/material.h"
#include "scenes/bsdfs/roughness.h"
#include "scenes/bsdfs/roughplastic.h"

namespace plumb {

/// A smooth coat with the share of a diffuse base's light that it sends back. One is made for each material.
struct SmoothCoat {
    explicit SmoothCoat(double index) : eta(index), returned(mean_fresnel_dielectric(1 / index)) {}
    double eta;       ///< its index over that outside, > 1
    double returned;  ///< the share of the base's light that it reflects back
};

/// A diffuse base under a smooth dielectric coat, with all the light that the coat throws back onto the base
/// [Mitsuba's plastic]. Black below.
struct Plastic {
    static constexpr std::string_view name = "plastic";
    static constexpr bool smooth = true;

    /// Where nonlinear, the base colours each of its reflections, not only the first.
    Plastic(const Spectrum& diffuse_reflectance, const SmoothCoat& coat, bool nonlinear);

    Spectrum diffuse_reflectance;
    Spectrum specular_reflectance = Spectrum::grey(1);  ///< a factor of no physics
    double eta;

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport) const;
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport) const;
    [[nodiscard]] double discrete(Vec3 wo) const { return wo.z > 0 ? mirror_probability(wo.z) : 0; }
    [[nodiscard]] Spectrum albedo() const { return diffuse_reflectance; }
    [[nodiscard]] double roughness() const { return 1; }

private:
    [[nodiscard]] double mirror_probability(double cos_o) const;

    Spectrum base_;        // of the base with all internal reflections, times 1/eta²
    double mirror_share_;  // of the coat in the sampling, against the base's
};

static_assert(NamedBsdfModel<Plastic>);

/// The light that leaves a base of reflectance ρ under a coat that returns the share r of it: ρ/(1 − ρ r), or ρ/(1 − r)
/// when only the first reflection is coloured.
Spectrum interreflected(const Spectrum& reflectance, double returned, bool nonlinear);

class PreparedPlastic;

namespace description {

/// A diffuse base under a dielectric coat.
struct Plastic {
    double eta = 1.49 / 1.000277;
    Colour diffuse_reflectance = Spectrum::grey(0.5), specular_reflectance = Spectrum::grey(1);
    bool nonlinear = false;  ///< inner reflections tint the base: ρ/(1−ρF) per wavelength
    std::optional<Roughness> roughness;

    using Closures = Types<plumb::Plastic, RoughPlastic>;
    static constexpr std::array plugins{Plugin{"plastic", "a diffuse base under a smooth dielectric coat"},
                                        Plugin{"roughplastic", "a diffuse base under a rough dielectric coat"}};
    static constexpr bool only_reflects = true;
    static Plastic load(Properties& properties);
    [[nodiscard]] Scatters scatters() const { return {true, !roughness}; }
    /// Throws Error for a coat of no higher index than outside.
    void check(const std::vector<Material>& all) const;
    /// The plastic with its coat's table, which is computed here.
    [[nodiscard]] PreparedPlastic prepared() const;
};

static_assert(MaterialModel<Plastic>);

}  // namespace description

/// A plastic with what is computed once for its coat.
class PreparedPlastic {
public:
    explicit PreparedPlastic(const description::Plastic& plastic);
    [[nodiscard]] Bsdf at(const Lookup& lookup) const;

private:
    description::Plastic plastic_;
    std::variant<SmoothCoat, std::shared_ptr<const RoughTransmittance>> coat_;
};

}  // namespace plumb
