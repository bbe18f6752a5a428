#pragma once

#include <variant>

#include "scenes/description/description.h"
#include "scenes/emitters/constant_environment.h"
#include "scenes/emitters/disk_light.h"
#include "scenes/emitters/environment_map.h"
#include "scenes/emitters/mesh_light.h"
#include "scenes/emitters/point_light.h"
#include "scenes/emitters/rectangle_light.h"
#include "scenes/emitters/sphere_light.h"

namespace plumb {

/// An emitter of a scene, under the conventions of scenes/emitters/emitter.h.
using Light =
    std::variant<RectangleLight, MeshLight, SphereLight, DiskLight, PointLight, ConstantEnvironment, EnvironmentMap>;

/// The light that a shape with an emitter is. Throws Error naming file and line where it has no area, or is an ellipse.
Light area_light(const description::Shape& shape);

/// A light without a shape. Throws Error naming file and line for a picture that cannot be read or is no environment.
Light shapeless_light(const description::Emitter& emitter);

bool is_environment(const Light& light);

}  // namespace plumb
