#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/common_options.h"
#include "cli/verb.h"
#include "cli/verbs/render.h"
#include "core/error.h"
#include "integrators/drivers/render_until.h"
#include "integrators/integrators.h"
#include "integrators/references/path_classes.h"
#include "integrators/references/reference_cache.h"
#include "integrators/references/scene_identity.h"
#include "scenes/mitsuba/mitsuba_xml.h"
#include "scenes/shipped/shipped.h"

namespace plumb::cli::verbs {
namespace {

/// A render with a name in the cache.
struct Options : RenderOptions {
    Options() {
        integrator = "path";
        sampler = "sobol";
        most_samples = 1u << 20;
    }
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

int reference(const Options& options) {
    description::Scene loaded = load_mitsuba(scene_file(options.scene), {options.definitions, options.lenient});
    Provenance wanted = identity_of(options.scene, loaded);
    wanted.integrator = find_integrator(options.integrator).id;
    wanted.limits.max_edges = options.max_depth;
    if (!wanted.is_radiance())
        throw Error(fmt::format("the integrator '{}' makes no pictures to compare others with", options.integrator));
    method_of(options);  // or says which lengths it has
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
    Scene scene(std::move(loaded));
    print_what_is_left_out(options.integrator, scene);
    RenderOptions to_file = options;
    to_file.out = file.string();
    return cli::render(to_file, [&] { return std::move(scene); });
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    add_transport(verb, *options);
    add_seed_and_threads(verb, options->seed, options->threads);
    add_error(verb, *options)->required();
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
