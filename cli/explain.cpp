#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/explanation.h"
#include "cli/path_options.h"
#include "cli/run_info.h"
#include "core/file.h"

namespace plumb {

int explain(const ExplainOptions& options) {
    const auto estimator = estimator_of(options);
    if (!options.json.empty()) check_writable(options.json);
    const RunInfo info = start_run(options.seed, 1);
    const Scene scene = load_scene(options);
    const RenderSettings settings = settings_of(options, info.seed, scene.sensor().film());
    const Explanation told = explain(scene, *estimator, settings, options.x, options.y, options.sample);
    const ExplainedSample sample{options, scene, told};
    if (!options.json.empty()) write_file(options.json, explanation_json(sample));
    fmt::print("{}", explanation_text(sample));
    return 0;
}

}  // namespace plumb
