#pragma once

#include "scenes/bsdfs/conductor.h"
#include "scenes/bsdfs/dielectric.h"
#include "scenes/bsdfs/diffuse.h"
#include "scenes/bsdfs/mask.h"
#include "scenes/bsdfs/plastic.h"
#include "scenes/bsdfs/thindielectric.h"
#include "scenes/bsdfs/twosided.h"

namespace plumb {

namespace description {

/// All materials, under the conventions of scenes/bsdfs/material.h; each brings its closures with it.
using MaterialModels = Types<Diffuse, Conductor, Dielectric, Plastic, TwoSided, Mask, ThinDielectric>;

/// A material as the file has it.
struct Material {
    OneOf<MaterialModels> kind;
    std::string id;  ///< as the file names it, empty where it does not
    Place place;
};

template <class... Models>
Joined<typename Models::Closures...> closures_of(Types<Models...>);

}  // namespace description

/// All closures, under the conventions of scenes/bsdfs/bsdf_model.h.
using Closures = decltype(closures_of(description::MaterialModels{}));

}  // namespace plumb
