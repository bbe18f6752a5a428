#pragma once

#include "scenes/emitters/constant_environment.h"
#include "scenes/emitters/disk_light.h"
#include "scenes/emitters/environment_map.h"
#include "scenes/emitters/mesh_light.h"
#include "scenes/emitters/point_light.h"
#include "scenes/emitters/rectangle_light.h"
#include "scenes/emitters/sphere_light.h"

namespace plumb {

namespace description {

/// All emitters without a shape, each with `light()`, the light that it becomes.
using EmitterModels = Types<ConstantSky, EnvironmentMap, PointLight>;

/// An emitter without a shape, as the file has it.
struct Emitter {
    OneOf<EmitterModels> kind;
    Place place;
};

template <class... Models>
Types<decltype(std::declval<const Models&>().light())...> lights_of(Types<Models...>);

}  // namespace description

/// All lights that a shape can be. Each has `of(geometry, radiance)` for geometry that it takes, which may be empty
/// where it does not take it after all. The first that takes a shape is its light.
using AreaLights = description::Types<RectangleLight, MeshLight, SphereLight, DiskLight>;

/// All lights, under the conventions of scenes/emitters/light.h.
using Lights = description::Joined<AreaLights, decltype(lights_of(description::EmitterModels{}))>;

}  // namespace plumb
