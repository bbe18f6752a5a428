#include "integrators/references/scene_identity.h"

#include "core/version.h"

namespace plumb {

Provenance identity_of(const NamedScene& scene) {
    return {.scene = scene.name(), .scene_hash = scene.hash(), .version = std::string(version)};
}

}  // namespace plumb
