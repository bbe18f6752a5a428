#pragma once

#include <array>

#include "scenes/description/models.h"

namespace plumb::description {

/// An emitter with a shape: the shape's outside shines with this radiance to every side.
struct AreaEmitter {
    Spectrum radiance = Spectrum::grey(1);
    Place place;

    static constexpr std::array plugins{
        Plugin{"area", "the outside of a shape shines with one radiance to every side"}};
    static AreaEmitter load(Properties& properties) {
        return {properties.emission("radiance", Spectrum::grey(1)), properties.place()};
    }
};

}  // namespace plumb::description
