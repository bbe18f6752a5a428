#include "integrators/references/reference_cache.h"

#include <fmt/format.h>

#include "core/error.h"
#include "integrators/integrators.h"
#include "integrators/references/scene_identity.h"

namespace plumb {

namespace fs = std::filesystem;

fs::path reference_file(const fs::path& cache, const Provenance& wanted) {
    const std::optional<int> depth = wanted.longest_path();
    const bool cut = depth && Provenance{.integrator = wanted.integrator}.longest_path() != depth;
    return cache / fmt::format("{}-{}-{}{}.exr", wanted.scene, wanted.scene_hash, wanted.integrator,
                               cut ? fmt::format("-d{}", *depth) : "");
}

std::optional<Reference> find_reference(const fs::path& cache, const Provenance& wanted) {
    const fs::path file = reference_file(cache, wanted);
    if (!fs::is_regular_file(file)) return {};
    Image image = read_image(file);
    std::optional<Provenance> found = provenance_of(image, file.string());
    const bool same = found && found->scene_hash == wanted.scene_hash && found->integrator == wanted.integrator &&
                      found->longest_path() == wanted.longest_path() && found->is_radiance() &&
                      found->version == wanted.version && found->crop.width == found->film.width &&
                      found->crop.height == found->film.height;
    if (!same) return {};
    return Reference{file, std::move(image), std::move(*found)};
}

Reference require_reference(const fs::path& cache, const NamedScene& scene, std::optional<int> longest_path) {
    for (const NamedIntegrator* integrator : reference_integrators()) {
        Provenance wanted = identity_of(scene);
        wanted.integrator = integrator->id;
        wanted.limits = {.max_edges = wanted.longest_path() ? -1 : longest_path.value_or(-1)};
        if (wanted.longest_path() != longest_path) continue;
        if (auto found = find_reference(cache, wanted)) return std::move(*found);
    }
    const std::string depth = longest_path ? fmt::format(" --max-depth {}", *longest_path) : "";
    throw Error(fmt::format("there is no reference of {} in {}; make one by: plumb reference {} --error 1%{}",
                            scene.asked, cache.string(), scene.asked, depth));
}

}  // namespace plumb
