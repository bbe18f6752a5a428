#pragma once

#include <algorithm>

#include "scenes/bsdfs/material.h"

namespace plumb::description {

/// Another material that rays meet with probability `opacity`, and else pass.
struct Mask {
    Colour opacity = Spectrum::grey(0.5);
    MaterialId nested;

    using Closures = Types<>;
    static constexpr std::array plugins{Plugin{"mask", "another bsdf where it is opaque, nothing elsewhere"}};
    static constexpr bool only_reflects = false;
    static Mask load(Properties& properties);
    [[nodiscard]] Scatters scatters() const { return {}; }
    [[nodiscard]] double opacity_at(const Lookup& lookup) const {
        return std::clamp(luminance(lookup.colour(opacity)), 0.0, 1.0);
    }
    [[nodiscard]] Bsdf at(const Lookup& lookup) const;
};
static_assert(MaterialModel<Mask>);

}  // namespace plumb::description
