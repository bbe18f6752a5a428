#include "integrators/references/scene_identity.h"

#include <fmt/format.h>

#include "core/version.h"
#include "scenes/shipped/shipped.h"

namespace plumb {

Provenance identity_of(const std::string& scene, const description::Scene& loaded) {
    return {.scene = scene_name(scene_file(scene)),
            .scene_hash = fmt::format("{:016x}", loaded.content_hash),
            .version = std::string(version)};
}

Provenance identity_of(const std::string& scene, const LoadOptions& options) {
    return identity_of(scene, load_mitsuba(scene_file(scene), options));
}

}  // namespace plumb
