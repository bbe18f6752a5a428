#pragma once

#include <concepts>
#include <vector>

#include "scenes/description/models.h"
#include "scenes/textures/texture.h"

namespace plumb {

struct Bsdf;
class Materials;
namespace description {
struct Material;
}

/// The kinds of scattering that a material has: with a density per steradian, and as mirrors and smooth interfaces do.
struct Scatters {
    bool smoothly = false, by_mirror = false;
};

/// A hit as a material asks for it: the texture coordinates, the side, and what else of the scene it may look up there.
struct Lookup {
    const Materials& materials;
    const std::vector<TextureLookup>& textures;
    std::array<double, 2> uv;
    bool outside;

    [[nodiscard]] Spectrum colour(const description::Colour& colour) const {
        return value(colour, textures, uv[0], uv[1]);
    }
    /// The closure of another material at this hit, as seen from outside or from inside.
    [[nodiscard]] Bsdf nested(description::MaterialId material, bool from_outside) const;
};

// Conventions of every material, as the file has it. Beside what the concept asks for:
//   Bsdf at(const Lookup&) const;             the closure at a hit: the material's, or that of what prepared() returns;
// and, where it has them,
//   void check(const std::vector<description::Material>& all) const;   throws Error for what no closure can do;
//   double opacity_at(const Lookup&) const;                            the chance that a ray meets the surface at all.
template <class M>
concept MaterialModel = requires(description::Properties& properties, const M& material) {
    { M::plugins.front() } -> std::convertible_to<description::Plugin>;
    { M::load(properties) } -> std::same_as<M>;
    /// The closures of numbers that it becomes at a hit, its own alone: Types<…>.
    typename M::Closures;
    /// Whether nothing passes it, so that it may be one side of a two-sided one.
    { M::only_reflects } -> std::convertible_to<bool>;
    /// What the material does by itself: two-sided ones and masks leave scattering to the materials within.
    { material.scatters() } -> std::same_as<Scatters>;
};

}  // namespace plumb
