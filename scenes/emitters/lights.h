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

/// The density of sample(from) for a direction, per steradian, towards a point of the light where it shines to the side
/// of `normal`; for an environment, whatever the point; of a point light the probability 1. That the direction meets
/// the light is not asked again: a ray started a rounding error beside `from`, and a direction at the light's rim that
/// misses it from there would have density 0, hence the whole weight: a firefly.
double pdf_of_sample(const Light& light, Vec3 from, Vec3 direction, Vec3 position, Vec3 normal);

}  // namespace plumb
