#include "scenes/bsdfs/mask.h"

#include "scenes/bsdfs/bsdf.h"

namespace plumb::description {

Mask Mask::load(Properties& properties) {
    const Colour opacity = properties.reflectance("opacity", Spectrum::grey(0.5));
    return {opacity, properties.nested_materials(1).front()};
}

Bsdf Mask::at(const Lookup& lookup) const {
    return lookup.nested(nested, lookup.outside);
}

}  // namespace plumb::description
