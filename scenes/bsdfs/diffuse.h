#pragma once

#include "scenes/bsdfs/bsdf_model.h"
#include "scenes/bsdfs/material.h"

namespace plumb {

/// Lambert's surface, which reflects above and is black below.
struct Diffuse {
    static constexpr std::string_view name = "diffuse";
    static constexpr bool smooth = true;

    Spectrum reflectance = Spectrum::grey(0.5);

    [[nodiscard]] Spectrum eval(Vec3 wo, Vec3 wi, Transport) const;
    [[nodiscard]] double pdf(Vec3 wo, Vec3 wi) const;
    [[nodiscard]] std::optional<BsdfSample> sample(Vec3 wo, const std::array<double, 3>& u, Transport) const;
    [[nodiscard]] double discrete(Vec3) const { return 0; }
    [[nodiscard]] Spectrum albedo() const { return reflectance; }
    [[nodiscard]] double roughness() const { return 1; }
};

static_assert(NamedBsdfModel<Diffuse>);

namespace description {

/// A diffuse material, with a reflectance that may be textured.
struct Diffuse {
    Colour reflectance = Spectrum::grey(0.5);

    using Closures = Types<plumb::Diffuse>;
    static constexpr std::array plugins{Plugin{"diffuse", "Lambert's surface"}};
    static constexpr bool only_reflects = true;
    static Diffuse load(Properties& properties);
    [[nodiscard]] Scatters scatters() const { return {.smoothly = true}; }
    [[nodiscard]] Bsdf at(const Lookup& lookup) const;
};

static_assert(MaterialModel<Diffuse>);

}  // namespace description

}  // namespace plumb
