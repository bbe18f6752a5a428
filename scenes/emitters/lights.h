#pragma once

#include <variant>

#include "scenes/emitters/all.h"
#include "scenes/geometry/shape.h"

namespace plumb {

/// A light of a scene, under the conventions of scenes/emitters/light.h.
using Light = description::OneOf<Lights>;

/// The light that a shape with an emitter is. Throws Error naming file and line where it can be none. The light of a
/// masked mesh is a light of triangles, which know the texture coordinates of their points.
Light area_light(const description::Shape& shape, bool masked = false);

/// The texture coordinates that a ray finds at the point which the light of a masked shape chose for u, or, of a shape
/// that is no mesh, at this position.
std::array<double, 2> uv_on_light(const description::Shape& shape, const Light& light, const Point<2>& u,
                                  Vec3 position);

/// A light without a shape. Throws Error naming file and line for a picture that cannot be read or is no environment.
Light shapeless_light(const description::Emitter& emitter);

inline LightKind kind_of(const Light& light) {
    return std::visit([](const auto& one) { return one.kind; }, light);
}
inline bool is_environment(const Light& light) {
    return kind_of(light) == LightKind::environment;
}

/// The density of sample(from) for a direction, per steradian, towards a point of the light where it shines to the side
/// of `normal`; for an environment, whatever the point; for a point light the probability 1. Whether the direction
/// meets the light is not asked again: a ray started a rounding error beside `from`, and a direction at the light's rim
/// that misses it from there would have density 0, hence the whole weight: a firefly.
double pdf_of_sample(const Light& light, Vec3 from, Vec3 direction, Vec3 position, Vec3 normal);

}  // namespace plumb
