#pragma once

#include "integrators/references/provenance.h"
#include "scenes/shipped/loaded_scene.h"

namespace plumb {

/// What a picture of the scene says of it, and this program's version; the rest is for the caller to say.
Provenance identity_of(const LoadedScene& scene);

}  // namespace plumb
