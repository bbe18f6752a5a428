#include <CLI/CLI.hpp>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/verb.h"
#include "cli/verbs/explain/explanation.h"
#include "cli/verbs/path_options.h"
#include "core/error.h"
#include "core/file.h"

namespace plumb::cli::verbs {
namespace {

/// One path of a render.
struct Options : PathOptions {
    int x = 0, y = 0;  ///< of the pixel
    std::uint32_t sample = 0;
    std::uint32_t replicates = 0;  ///< passes of the render; 0: as `render --spp` cuts them
    std::string json;
};

// Sets of points, of sobol and stratified samples, are as long as a pass.
void cut(RenderSettings& settings, std::uint32_t samples, std::uint32_t passes) {
    if (samples % passes != 0)
        throw Error(
            fmt::format("{} samples a pixel in {} replicates: accepted are divisors of the samples", samples, passes));
    settings.passes = passes;
    settings.samples_per_pass = samples / passes;
}

int explain(const Options& options) {
    ReadScene read = read_scene(options.scene, options.load);
    const RenderMethod method = method_of(options, read.description);
    const auto estimator = estimator_of(method);
    require_writable({options.json});
    const Session session(options.seed, 1);
    const LoadedScene scene = made_ready(std::move(read));
    RenderSettings settings = settings_of(options, session.run.seed, scene.scene.sensor().film());
    if (options.replicates > 0) cut(settings, options.samples_per_pixel, options.replicates);
    const RenderJob job = job_of(method, scene.scene, *estimator, settings);
    const Explanation told = explain(job, options.x, options.y, options.sample);
    const ExplainedSample sample{scene, method, settings, options.x, options.y, options.sample, told};
    if (!options.json.empty()) write_file(options.json, explanation_json(sample));
    fmt::print("{}", explanation_text(sample));
    return 0;
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    add_paths(verb, *options);
    verb.add_option("x", options->x, "the pixel's column, 0 at the left")->required();
    verb.add_option("y", options->y, "the pixel's row, 0 at the top")->required();
    verb.add_option("sample", options->sample, "which of the pixel's samples, 0 to spp - 1")->required();
    verb.add_option(
            "--replicates", options->replicates,
            "passes of the render, where --spp did not set them: give spp and replicates as the image's metadata do")
        ->check(CLI::Range(1u, 1u << 24));
    add_seed(verb, options->seed);
    verb.add_option("--json", options->json, "write all of it as JSON to this file, every number to the bit");
    verb.footer(
        "The path is that of plumb render with the same options: give it the seed of the image.\n\n"
        "Example: plumb explain cornell_box 64 100 3 --integrator path --seed 7");
    return [options](const Catalogue&) { return explain(*options); };
}

}  // namespace

Verb explain() {
    return {"explain", "Explain one path of a render: vertices, densities, weights, splats", add};
}

}  // namespace plumb::cli::verbs
