#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/explanation.h"
#include "cli/path_options.h"
#include "cli/run_info.h"
#include "core/error.h"
#include "core/file.h"

namespace plumb::cli {
namespace {

// Sets of points, of sobol and stratified samples, are as long as a pass.
void cut(RenderSettings& settings, std::uint32_t samples, std::uint32_t passes) {
    if (samples % passes != 0)
        throw Error(
            fmt::format("{} samples a pixel in {} replicates: accepted are divisors of the samples", samples, passes));
    settings.passes = passes;
    settings.samples_per_pass = samples / passes;
}

}  // namespace

int explain(const ExplainOptions& options) {
    const auto estimator = estimator_of(options);
    if (!options.json.empty()) check_writable(options.json);
    const reports::RunInfo info = start_run(options.seed, 1);
    const Scene scene = load_scene(options);
    RenderSettings settings = settings_of(options, info.seed, scene.sensor().film());
    if (options.replicates > 0) cut(settings, options.samples_per_pixel, options.replicates);
    const Explanation told = explain(scene, *estimator, settings, options.x, options.y, options.sample);
    const ExplainedSample sample{options, scene, told};
    if (!options.json.empty()) write_file(options.json, explanation_json(sample));
    fmt::print("{}", explanation_text(sample));
    return 0;
}

}  // namespace plumb::cli
