#pragma once

#include "scenes/bsdfs/microfacet.h"
#include "scenes/description/properties.h"

namespace plumb::description {

/// The distributions of microfacet slopes that scene files can name.
enum class Microfacets { beckmann, ggx };

/// The distribution of facets that all rough materials have.
struct Roughness {
    Microfacets distribution = Microfacets::beckmann;
    double alpha = 0.1;  ///< root mean square slope (Beckmann) or its analogue (GGX), > 0

    static Roughness load(Properties& properties);
    [[nodiscard]] plumb::Microfacets facets() const {
        return {distribution == Microfacets::ggx ? MicrofacetShape::ggx : MicrofacetShape::beckmann, alpha};
    }
};

}  // namespace plumb::description
