#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/values.h"
#include "cli/verb.h"
#include "cli/verbs/path_options.h"
#include "cli/verbs/render_picture.h"
#include "core/error.h"
#include "core/images/image.h"

namespace plumb::cli::verbs {
namespace {

namespace fs = std::filesystem;

struct Options : PathOptions {
    RenderEnd end;  ///< in place of samples_per_pixel
    std::optional<Shard> shard;
    int threads = 0;
    std::string out;  ///< empty: out/SCENE.exr
};

fs::path output_of(const Options& options, const LoadedScene& scene) {
    if (!options.out.empty()) return options.out;
    const auto& shard = options.shard;
    return fs::path("out") /
           (shard ? fmt::format("{}-{}-of-{}.film", scene.name(), shard->index, shard->count) : scene.name() + ".exr");
}

// Nothing to see and nothing to see it by: a mistake, not a picture.
void require_content(const LoadedScene& scene) {
    const description::Scene& has = scene.scene.description();
    if (has.shapes.empty() && has.emitters.empty())
        throw Error(fmt::format("{}: has no shapes and no emitters; accepted: a scene with one of them at least",
                                scene.file.string()));
}

int render(const Options& options) {
    ReadScene read = read_scene(options.scene, options.load);
    const RenderMethod method = method_of(options, read.description);
    Session session(options.seed, options.threads);
    const LoadedScene scene = made_ready(std::move(read));
    require_content(scene);
    const fs::path out = output_of(options, scene);
    require_writable({out});
    if (!options.shard) check_image_format(out);
    RenderSettings settings = settings_of(options, session.run.seed, scene.scene.sensor().film());
    if (options.end.time) settings.passes = 1u << 20;
    if (options.shard) settings = part_of(settings, options.shard->index, options.shard->count);
    const bool ends_itself = options.end.time || options.end.error;
    return render_picture(
        {scene, method, settings, options.end, options.shard, out, ends_itself ? 0 : options.samples_per_pixel},
        session);
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    add_paths(verb, *options);
    CLI::Option* spp = verb.get_option("--spp");
    CLI::Option* time = add_parsed(verb, "--time", options->end.time, parse_duration,
                                   "instead of --spp: render as many passes of 4 samples as fit into, e.g., 30s")
                            ->excludes(spp);
    CLI::Option* error = add_error(verb, options->end)->excludes(spp)->excludes(time);
    add_seed_and_threads(verb, options->seed, options->threads);
    add_parsed(
        verb, "--shard", options->shard, parse_shard,
        "render every n-th pass from the i-th on, i/n, into a part of a film; plumb merge joins them. Needs --seed")
        ->needs(verb.get_option("--seed"))
        ->excludes(time)
        ->excludes(error);
    verb.add_option("-o,--output", options->out,
                    "the image, in a format that OpenImageIO writes; EXR and TIFF keep all layers [out/SCENE.exr]");
    verb.footer(
        "Exit code: 0, or 3 when --error was not reached, 2 usage or input error.\n\n"
        "Examples: plumb render cornell_box --sampler sobol --spp 64 -o cornell.exr\n"
        "          plumb render cornell_box --integrator path --error 2%");
    return [options](const Catalogue&) { return render(*options); };
}

}  // namespace

Verb render() {
    return {"render", "Render a scene to an image with its variance", add};
}

}  // namespace plumb::cli::verbs
