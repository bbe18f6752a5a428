#include <filesystem>

#include "cli/commands.h"
#include "cli/path_options.h"
#include "core/error.h"
#include "integrators/integrators.h"
#include "integrators/reference_cache.h"
#include "integrators/render_until.h"
#include "integrators/scene_identity.h"

namespace plumb {

int reference(const ReferenceOptions& options) {
    Provenance wanted = identity_of(options.scene, {options.definitions, options.lenient});
    wanted.integrator = find_integrator(options.integrator).id;
    wanted.limits.max_edges = options.max_depth;
    if (!wanted.is_radiance())
        throw Error(fmt::format("the integrator '{}' makes no pictures to compare others with", options.integrator));
    estimator_of(options);  // or says which lengths it has
    const std::filesystem::path file = reference_file(options.cache, wanted);
    if (const auto found = find_reference(options.cache, wanted)) {
        const Provenance& has = found->provenance;
        const bool met = meets(has.error, *options.error);
        const std::string says =
            fmt::format("{}: relative error {:.3g} % (RMSE {:.3g}), {} samples a pixel, seed {}", file.string(),
                        100 * has.error.relative, has.error.rmse, has.samples_per_pixel, has.seed);
        const std::uint32_t pass = RenderSettings{}.samples_per_pass;  // what is less than that is not rendered
        if (met || has.samples_per_pixel + pass > options.most_samples) {
            fmt::print("{}; {}\n", says, met ? "nothing to do" : "more needs a larger --max-spp");
            return met ? 0 : 3;
        }
        fmt::print("{}; rendered anew\n", says);
    }
    RenderOptions to_file = options;
    to_file.out = file.string();
    return render(to_file);
}

}  // namespace plumb
