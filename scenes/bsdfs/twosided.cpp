#include "scenes/bsdfs/twosided.h"

#include "scenes/bsdfs/bsdf.h"

namespace plumb::description {

TwoSided TwoSided::load(Properties& properties) {
    const std::vector<MaterialId> sides = properties.nested_materials(2);
    return {sides.front(), sides.back()};
}

void TwoSided::check(const std::vector<Material>& all) const {
    for (const MaterialId side : {front, back})
        if (!std::visit([](const auto& material) { return material.only_reflects; }, all[side.index].kind))
            throw Error(
                "'twosided' around a dielectric, a mask or another 'twosided'; accepted are bsdfs that only reflect");
}

Bsdf TwoSided::at(const Lookup& lookup) const {
    Bsdf bsdf = lookup.nested(lookup.outside ? front : back, true);
    bsdf.two_sided = true;
    return bsdf;
}

}  // namespace plumb::description
