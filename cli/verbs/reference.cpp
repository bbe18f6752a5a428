#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/common_options.h"
#include "cli/verb.h"
#include "cli/verbs/path_options.h"
#include "core/error.h"
#include "integrators/drivers/render_until.h"
#include "integrators/integrators.h"
#include "integrators/references/path_classes.h"
#include "integrators/references/reference_cache.h"
#include "integrators/references/scene_identity.h"

namespace plumb::cli::verbs {
namespace {

struct Options : PathOptions {
    Options() {
        integrator = "path";
        sampler = "sobol";
        end.most_samples = 1u << 20;
    }
    RenderEnd end;
    int threads = 0;
    std::string cache = "out/references";
};

// What the picture will lack is not noise, and no error tells it.
void print_what_is_left_out(const std::string& integrator, const Scene& scene) {
    const Makes& makes = find_integrator(integrator).makes;
    const int most_edges = std::min(4, makes.longest.value_or(4));
    std::vector<std::string> classes;
    for (const PathClass& path : left_out(makes.path, scene, most_edges)) classes.push_back(to_string(path));
    if (!classes.empty())
        fmt::print("`{}` leaves out light that `bdpt` finds in this scene, such as {}\n", integrator, classes.front());
}

/// The exit code where the picture that is there is enough; empty where another is to be rendered.
std::optional<int> kept(const std::filesystem::path& file, const Provenance& has, const RenderEnd& end) {
    const bool met = meets(has.error, *end.error);
    const std::string says =
        fmt::format("{}: relative error {:.3g} % (RMSE {:.3g}), {} samples a pixel, seed {}", file.string(),
                    100 * has.error.relative, has.error.rmse, has.samples_per_pixel, has.seed);
    const std::uint32_t pass = RenderSettings{}.samples_per_pass;  // what is less than that is not rendered
    const bool enough = met || has.samples_per_pixel + pass > end.most_samples;
    fmt::print("{}; {}\n", says, !enough ? "rendered anew" : met ? "nothing to do" : "more needs a larger --max-spp");
    return enough ? std::optional(met ? 0 : 3) : std::nullopt;
}

int reference(const Options& options) {
    ReadScene read = read_scene(options.scene, options.load);
    const RenderMethod method = method_of(options, read.description);
    Provenance wanted = identity_of(read);
    wanted.integrator = method.integrator;
    wanted.limits.max_edges = method.limits.max_edges;
    if (!wanted.is_radiance())
        throw Error(fmt::format("the integrator '{}' makes no pictures to compare others with", method.integrator));
    const std::filesystem::path file = reference_file(options.cache, wanted);
    if (const auto found = find_reference(options.cache, wanted))
        if (const auto exit_code = kept(file, found->provenance, options.end)) return *exit_code;
    const LoadedScene scene = made_ready(std::move(read));
    print_what_is_left_out(method.integrator, scene.scene);
    require_writable({file});
    Session session(options.seed, options.threads);
    const RenderSettings settings = settings_of(options, session.run.seed, scene.scene.sensor().film());
    return render_picture({scene, method, settings, options.end, {}, file}, session);
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    add_transport(verb, *options);
    add_seed_and_threads(verb, options->seed, options->threads);
    add_error(verb, options->end)->required();
    add_cache(verb, options->cache);
    verb.footer(
        "Does nothing where such a reference is there already. Exit code: 0, or 3 when --error was not reached,\n"
        "2 usage or input error.\n\n"
        "Example: plumb reference cornell_box --error 1%");
    return [options](const Catalogue&) { return reference(*options); };
}

}  // namespace

Verb reference() {
    return {"reference", "Keep a picture of a scene that others are measured against", add};
}

}  // namespace plumb::cli::verbs
