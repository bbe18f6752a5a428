#pragma once

#include "scenes/bsdfs/material.h"

namespace plumb::description {

/// A material on each side, which does on its side what it does above when it stands alone.
struct TwoSided {
    MaterialId front, back;

    using Closures = Types<>;
    static constexpr std::array plugins{Plugin{"twosided", "one bsdf on both sides, or one on each"}};
    static constexpr bool only_reflects = false;
    static TwoSided load(Properties& properties);
    [[nodiscard]] Scatters scatters() const { return {}; }
    /// Throws Error unless both sides only reflect.
    void check(const std::vector<Material>& all) const;
    [[nodiscard]] Bsdf at(const Lookup& lookup) const;
};
static_assert(MaterialModel<TwoSided>);

}  // namespace plumb::description
