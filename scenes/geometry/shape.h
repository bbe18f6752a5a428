#pragma once

#include <optional>
#include <utility>

#include "scenes/description/area_emitter.h"
#include "scenes/geometry/all.h"

namespace plumb::description {

template <class... Models>
OneOf<Types<decltype(Models::load(std::declval<Properties&>()))...>> geometry_of(Types<Models...>);
using Geometry = decltype(geometry_of(ShapeModels{}));

/// A shape as the file has it, in world space.
struct Shape {
    Geometry geometry;
    MaterialId material;
    std::optional<AreaEmitter> emitter;
    std::string id;
    Place place;
};

/// A box around all of the geometry.
Box bounds(const Geometry& geometry);

}  // namespace plumb::description
