#include <charconv>

#include "cli/option_adders.h"

// Options of the verbs that judge images.
namespace plumb {
namespace {

void add_share(CLI::App* verb, const std::string& name, double& share, const std::string& about) {
    verb->add_option_function<std::string>(
            name, [&share](const std::string& text) { share = parse_error_target(text).error; },
            fmt::format("{} [{} %]", about, 100 * share))
        ->check(checked(parse_error_target));
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

}  // namespace plumb
