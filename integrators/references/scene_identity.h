#pragma once

#include "integrators/references/provenance.h"
#include "scenes/shipped/loaded_scene.h"

namespace plumb {

/// The name and hash of a scene, with this program's version; the caller says the rest.
Provenance identity_of(const NamedScene& scene);

}  // namespace plumb
