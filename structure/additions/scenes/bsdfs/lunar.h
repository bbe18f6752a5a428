#pragma once

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/material.h"

namespace plumb {

/// Dust that scatters light once, after Lommel and Seeliger: f = w / (4π (cos θi + cos θo)), w the albedo of a grain.
/// The full moon is as bright at its rim as in its middle. Reflects above, black below. With μ = cos θ the reflectance
/// is ∫ f μi dωi = w/2 ∫ μi/(μi + μo) dμi = w/2 (1 − μo ln(1 + 1/μo)) ≤ w/2.
struct Lunar {
    static constexpr std::string_view name = "lunar";
    static constexpr bool smooth = true;

    Spectrum grain = Spectrum::grey(0.5);

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport) const;
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport) const;
    [[nodiscard]] double discrete(Vec3) const { return 0; }
    [[nodiscard]] Spectrum albedo() const { return grain * 0.5; }
    [[nodiscard]] double roughness() const { return 1; }
};
static_assert(NamedBsdfModel<Lunar>);

namespace description {

struct Lunar {
    Colour grain = Spectrum::grey(0.5);

    using Closures = Types<plumb::Lunar>;
    static constexpr std::array plugins{Plugin{"lunar", "dust that scatters once, as the moon's"}};
    static constexpr bool only_reflects = true;
    static Lunar load(Properties& properties);
    [[nodiscard]] Scatters scatters() const { return {.smoothly = true}; }
    [[nodiscard]] Bsdf at(const Lookup& lookup) const;
};
static_assert(MaterialModel<Lunar>);

}  // namespace description

}  // namespace plumb
