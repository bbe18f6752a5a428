#pragma once

#include <variant>

#include "scenes/emitters/all.h"
#include "scenes/geometry/shape.h"

namespace plumb {

/// An emitter of a scene, under the conventions of scenes/emitters/emitter.h.
using Light = description::OneOf<Lights>;

/// The light that a shape with an emitter is. Throws Error naming file and line where it can be none.
Light area_light(const description::Shape& shape);

/// A light without a shape. Throws Error naming file and line for a picture that cannot be read or is no environment.
Light shapeless_light(const description::Emitter& emitter);

inline EmitterKind kind_of(const Light& light) {
    return std::visit([](const auto& one) { return one.kind; }, light);
}
inline bool is_environment(const Light& light) {
    return kind_of(light) == EmitterKind::environment;
}

}  // namespace plumb
