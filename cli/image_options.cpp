#include <charconv>

#include "cli/option_adders.h"

// Options of the verbs that make images or judge them.
namespace plumb::cli {
namespace {

void add_share(CLI::App* verb, const std::string& name, double& share, const std::string& about) {
    verb->add_option_function<std::string>(
            name, [&share](const std::string& text) { share = parse_error_target(text).error; },
            fmt::format("{} [{} %]", about, 100 * share))
        ->check(checked(parse_error_target));
}

// A scene, and how its light is transported.
void add_transport(CLI::App* verb, PathOptions& options) {
    verb->add_option("scene", options.scene, "a scene in Mitsuba's XML, or the name of a shipped one")->required();
    verb->add_option("--integrator", options.integrator, "see plumb list integrators")->capture_default_str();
    verb->add_option("--sampler", options.sampler, "independent, stratified or sobol")->capture_default_str();
    verb->add_option("--max-depth", options.max_depth,
                     "longest paths, in edges from the sensor (1: lights seen directly); -1: no limit")
        ->check(CLI::Range(-1, 30000))
        ->capture_default_str();
    verb->add_option("--rr-depth", options.roulette_depth, "Russian roulette begins behind so many edges")
        ->check(CLI::Range(0, 30000))
        ->capture_default_str();
    verb->add_option_function<std::vector<std::string>>(
            "-D",
            [&](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options.definitions.insert(parse_definition(text));
            },
            "name=value for $name in the file")
        ->check(checked(parse_definition));
    verb->add_flag("--lenient", options.lenient, "replace what Plumb lacks where it can, and list it");
}

void add_paths(CLI::App* verb, PathOptions& options) {
    add_transport(verb, options);
    verb->add_option("--length", options.length, "only paths of so many edges; 0: of all")
        ->check(CLI::Range(0, 30000))
        ->capture_default_str();
    verb->add_option_function<std::string>(
            "--strategy", [&](const std::string& text) { options.strategy = parse_strategy(text); },
            "of `bdpt`, one alone and unweighted: s,t for s vertices from the light and t from the sensor")
        ->check(checked(parse_strategy));
    verb->add_option("--spp", options.samples_per_pixel, "samples a pixel")
        ->check(CLI::Range(1u, 1u << 24))
        ->capture_default_str();
    verb->add_option_function<std::string>(
            "--crop", [&](const std::string& text) { options.crop = parse_crop(text); },
            "only these pixels: x,y,width,height")
        ->check(checked(parse_crop));
}

// Returns --error.
CLI::Option* add_error(CLI::App* verb, RenderOptions& options) {
    CLI::Option* error =
        verb->add_option_function<std::string>(
                "--error", [&](const std::string& text) { options.error = parse_error_target(text); },
                "double the passes until the picture's RMSE is at most this, 1e-3, or 1% of the picture")
            ->check(checked(parse_error_target));
    verb->add_option("--max-spp", options.most_samples, "samples a pixel, where --error gives up")
        ->check(CLI::Range(64u, 1u << 24))
        ->needs(error)
        ->capture_default_str();
    return error;
}

}  // namespace

const CLI::Validator& probability() {
    static const CLI::Validator in_0_1(
        [](const std::string& text) -> std::string {
            double value = 0;
            const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
            const bool number = failure == std::errc() && end == text.data() + text.size();
            return number && value > 0 && value < 1 ? "" : fmt::format("'{}' is not a number in (0, 1)", text);
        },
        "in (0, 1)");
    return in_0_1;
}

void add_cache(CLI::App* verb, std::string& cache) {
    verb->add_option("--cache", cache, "the folder where plumb reference keeps its pictures")->capture_default_str();
}

void add_render(CLI::App& app, RenderOptions& options) {
    CLI::App* verb = app.add_subcommand("render", "Render a scene to an image with its variance");
    add_paths(verb, options);
    verb->add_option_function<std::string>(
            "--time", [&](const std::string& text) { options.time = parse_duration(text); },
            "instead of --spp: as many passes of 4 samples as fit, e.g. 30s")
        ->check(checked(parse_duration))
        ->excludes(verb->get_option("--spp"));
    add_error(verb, options)->excludes(verb->get_option("--spp"))->excludes(verb->get_option("--time"));
    add_seed_and_threads(verb, options.seed, options.threads);
    verb->add_option_function<std::string>(
            "--shard", [&](const std::string& text) { options.shard = parse_shard(text); },
            "every n-th pass from the i-th on, i/n, into a part of a film: plumb merge joins them. Needs --seed")
        ->check(checked(parse_shard))
        ->needs(verb->get_option("--seed"))
        ->excludes(verb->get_option("--time"))
        ->excludes(verb->get_option("--error"));
    verb->add_option("-o,--output", options.out,
                     "the image, in a format that OpenImageIO writes; EXR and TIFF keep all layers [out/SCENE.exr]");
    verb->footer(
        "Exit code: 0, or 3 when --error was not reached, 2 usage or input error.\n\n"
        "Examples: plumb render cornell_box --sampler sobol --spp 64 -o cornell.exr\n"
        "          plumb render cornell_box --integrator path --error 2%");
}

void add_explain(CLI::App& app, ExplainOptions& options) {
    CLI::App* verb =
        app.add_subcommand("explain", "Explain one path of a render: vertices, densities, weights, splats");
    add_paths(verb, options);
    verb->add_option("x", options.x, "the pixel's column, from the left and 0")->required();
    verb->add_option("y", options.y, "its row, from the top")->required();
    verb->add_option("sample", options.sample, "which of its samples, from 0 to spp - 1")->required();
    verb->add_option("--replicates", options.replicates,
                     "passes of the render, where --spp did not say them: spp and replicates of the image's metadata")
        ->check(CLI::Range(1u, 1u << 24));
    add_seed(verb, options.seed);
    verb->add_option("--json", options.json, "write all of it as JSON to this file, every number to the bit");
    verb->footer(
        "The path is that of plumb render with the same options: give it the seed of the image.\n\n"
        "Example: plumb explain cornell_box 64 100 3 --integrator path --seed 7");
}

void add_reference(CLI::App& app, ReferenceOptions& options) {
    CLI::App* verb = app.add_subcommand("reference", "Keep a picture of a scene that others are measured against");
    add_transport(verb, options);
    add_seed_and_threads(verb, options.seed, options.threads);
    add_error(verb, options)->required();
    add_cache(verb, options.cache);
    verb->footer(
        "Does nothing where such a reference is there already. Exit code: 0, or 3 when --error was not reached,\n"
        "2 usage or input error.\n\n"
        "Example: plumb reference cornell_box --error 1%");
}

void add_compare(CLI::App& app, CompareOptions& options) {
    CLI::App* verb = app.add_subcommand("compare", "Are two images estimates of the same picture?");
    verb->add_option("images", options.images,
                     "image a and image b, of any renderer; b may be a scene, for its reference")
        ->expected(0, 2);
    verb->add_option("--a", options.a, "independent renders of a: two or more unless a has layers of its variance");
    verb->add_option("--b", options.b, "independent renders of b");
    verb->add_flag("--exact-b", options.exact_b, "b has no error: a closed form, not a render");
    add_cache(verb, options.cache);
    add_share(verb, "--delta", options.settings.delta, "how far the picture's mean may be off, of b's");
    add_share(verb, "--tile-delta", options.settings.tile_delta, "how far a tile's mean may be off, of b's");
    verb->add_option("--tile", options.settings.tile, "edge of a tile in pixels; about 256 tiles when not given")
        ->check(CLI::Range(2, 1 << 16));
    verb->add_option("--alpha", options.settings.alpha, "the risk of refuting two true estimates")
        ->check(probability())
        ->capture_default_str();
    verb->add_option("--json", options.json, "write everything but the pixels as JSON to this file");
    verb->add_option("--report", options.report, "the page with both images; '' for none")->capture_default_str();
    verb->footer(
        "Exit code: 0 equal within delta, 1 refuted, 2 usage or input error, 3 undecided. docs/compare.md says what "
        "is\n"
        "tested and what it cannot see.\n\n"
        "Example: plumb compare path.exr bdpt.exr --delta 0.5%");
}

void add_check(CLI::App& app, CheckOptions& options) {
    CLI::App* verb = app.add_subcommand("check", "Has an image the radiances that are known of its scene?");
    verb->add_option("images", options.images, "an image of any renderer, or several independent renders of it")
        ->required();
    verb->add_option("--expect", options.expected, "an expected.json (docs/scenes.md), or the name of a shipped scene")
        ->required();
    verb->add_option_function<std::string>(
            "--edges", [&](const std::string& text) { options.edges = parse_edges(text); },
            "the longest paths that the image counts: 2 (direct light), or all; Plumb's own images say it themselves")
        ->check(checked(parse_edges));
    add_share(verb, "--delta", options.settings.delta, "how far a value may be off, of what is known");
    verb->add_option("--alpha", options.settings.alpha, "the risk of refuting an image that is right")
        ->check(probability())
        ->capture_default_str();
    verb->add_option("--json", options.json, "write all values as JSON to this file");
    verb->footer(
        "Exit code: 0 all values are as known, 1 refuted, 2 usage or input error, 3 undecided. docs/compare.md.\n\n"
        "Example: plumb check render.exr --expect quad_light --edges all");
}

}  // namespace plumb::cli
