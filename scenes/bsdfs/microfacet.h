#pragma once

#include <array>

#include "core/vec3.h"

namespace plumb {

/// The distributions of microfacet slopes that closures know.
enum class MicrofacetShape { ggx, beckmann };

/// An isotropic distribution of microfacet normals m, with Smith's masking [Heitz 2014]. Normals lie above (m.z > 0);
/// directions may lie on either side, and are masked by their own side.
struct Microfacets {
    MicrofacetShape shape = MicrofacetShape::ggx;
    double alpha = 0.1;  ///< roughness, > 0: the width of the distribution of slopes

    /// The area of facets per area of surface and steradian of m: ∫ D m.z dm = 1.
    [[nodiscard]] double d(Vec3 m) const;
    /// Smith's auxiliary function of a direction.
    [[nodiscard]] double lambda(Vec3 w) const;
    /// The unmasked share of the facets that face w: 1/(1 + lambda), and 0 for a facet seen from behind.
    [[nodiscard]] double g1(Vec3 w, Vec3 m) const;
    /// The share of facets that are neither masked nor shadowed, both taken as independent, as in Mitsuba.
    [[nodiscard]] double g2(Vec3 wo, Vec3 wi, Vec3 m) const { return g1(wo, m) * g1(wi, m); }

    /// The density, per steradian of m, of the normals that wo sees: G1 |wo·m| D / |wo.z|, which integrates to 1.
    [[nodiscard]] double visible_pdf(Vec3 wo, Vec3 m) const;
    /// A normal that wo sees, for wo.z > 0; smooth in u. In the last bits of u, where GGX's half vector vanishes,
    /// rounding can turn it away from wo: the caller tests wo·m > 0.
    [[nodiscard]] Vec3 sample_visible(Vec3 wo, const std::array<double, 2>& u) const;
};

}  // namespace plumb
