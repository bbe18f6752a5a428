#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/verb.h"
#include "cli/verbs/exit_code.h"
#include "core/error.h"
#include "core/file.h"
#include "core/images/image.h"
#include "core/images/layers.h"
#include "integrators/references/reference_cache.h"
#include "integrators/references/scene_identity.h"
#include "reports/images/comparison.h"
#include "reports/text/text.h"
#include "scenes/shipped/shipped.h"
#include "verification/pictures/flip.h"

namespace plumb::cli::verbs {
namespace {

struct Options {
    std::vector<std::string> images;  ///< a and b; b may be a scene, for its reference
    std::vector<std::string> a, b;    ///< more independent renders of each
    bool exact_b = false;             ///< b is a deterministic picture
    std::string layer_a, layer_b;     ///< of the images; empty: the picture itself, or the only one
    std::string cache = "out/references";
    ComparisonSettings settings;
    std::string json, report = "out/compare.html";
};

std::vector<std::string> files_of(const Options& options, std::size_t side) {
    std::vector<std::string> files;
    if (options.images.size() > side) files.push_back(options.images[side]);
    const std::vector<std::string>& more = side == 0 ? options.a : options.b;
    files.insert(files.end(), more.begin(), more.end());
    if (files.empty())
        throw Error(fmt::format("compare: there is no image {}; give two images, or lists of renders by --a and --b",
                                side == 0 ? 'a' : 'b'));
    return files;
}

// Image b may be named by its scene: its reference then, of paths as long as those of image a.
void find_reference(std::vector<std::string>& files_b, const std::string& file_a, const Image& a,
                    const std::string& cache) {
    const std::string asked = files_b.front();
    const bool image = std::filesystem::is_regular_file(asked) && std::filesystem::path(asked).extension() != ".xml";
    if (files_b.size() > 1 || image || !find_scene_file(asked)) return;
    const NamedScene scene = read_scene(asked, {.lenient = true});
    const Provenance identity = identity_of(scene);
    const std::optional<Provenance> said = provenance_of(a, file_a);
    if (said) require_same_scene(*said, identity, file_a);
    const auto longest = said ? longest_path_of(*said, file_a) : std::nullopt;
    files_b.front() = require_reference(cache, scene, longest).file.string();
}

// One image that does not tell its error is compared all the same, without a verdict.
Picture picture_of_side(const std::vector<Image>& images, const std::vector<std::string>& files, bool exact) {
    if (images.size() == 1 && !exact && !has_variance(images[0], files[0]))
        return picture_without_error(images[0], files[0]);
    return picture_of(images, files, exact);
}

void print_errors(const std::vector<ErrorMeasure>& errors) {
    for (const ErrorMeasure& error : errors) {
        fmt::print("{} {}", error.name, reports::readable(error.value));
        if (std::isfinite(error.interval.low) || std::isfinite(error.interval.high))
            fmt::print(" [{}, {}]", reports::readable(error.interval.low), reports::readable(error.interval.high));
        fmt::print("  ");
    }
    fmt::print("\n");
}

void print_tiles(const ImageComparison& found) {
    const auto print = [&](const char* title, const std::vector<std::size_t>& list) {
        if (list.empty()) return;
        fmt::print("{}:\n", title);
        std::vector<std::vector<std::string>> rows;
        for (std::size_t i = 0; i < std::min<std::size_t>(8, list.size()); ++i) {
            const TileTest& t = found.tiles[list[i]];
            rows.push_back({fmt::format("({}, {})", t.box.x, t.box.y), fmt::format("{}x{}", t.box.width, t.box.height),
                            found.channels[t.channel].channel, reports::readable(t.found.a),
                            reports::readable(t.found.b), reports::readable(t.found.z),
                            reports::readable(t.found.p_value), to_string(t.state)});
        }
        fmt::print("{}", reports::table({{"at"},
                                         {"pixels"},
                                         {"channel"},
                                         {"a", reports::Align::right},
                                         {"b", reports::Align::right},
                                         {"z", reports::Align::right},
                                         {"p", reports::Align::right},
                                         {"state"}},
                                        rows, 100));
        if (list.size() > rows.size()) fmt::print("… and {} more\n", list.size() - rows.size());
    };
    print("Tiles that differ, worst first", found.differing);
    print("Tiles that are not decided", found.undecided);
}

int compare(const Options& options) {
    const std::vector<std::string> files_a = files_of(options, 0);
    std::vector<std::string> files_b = files_of(options, 1);
    require_writable({options.json, options.report});
    std::vector<Image> images_a, images_b;
    for (const std::string& file : files_a) images_a.push_back(picture_layer(read_image(file), file, options.layer_a));
    find_reference(files_b, files_a.front(), images_a.front(), options.cache);
    for (const std::string& file : files_b) images_b.push_back(picture_layer(read_image(file), file, options.layer_b));
    std::vector<Image> all = images_a;
    std::vector<std::string> names = files_a;
    all.insert(all.end(), images_b.begin(), images_b.end());
    names.insert(names.end(), files_b.begin(), files_b.end());
    const Picture a = picture_of_side(images_a, files_a, false),
                  b = picture_of_side(images_b, files_b, options.exact_b);
    if (a.error_known && b.error_known) require_independent(all, names);
    ImageComparison found = compare(a, b, options.settings);
    for (ErrorMeasure& error : flip_errors_of(a, b)) found.errors.push_back(std::move(error));

    const reports::ComparisonReport report{files_a, files_b, a, b, options.settings, found};
    if (!options.json.empty()) write_output(options.json, reports::comparison_json(report));
    if (!options.report.empty()) write_output(options.report, reports::comparison_html(report));
    fmt::print("{}: {}\n", to_string(found.verdict.outcome), found.verdict.reason);
    print_tiles(found);
    print_errors(found.errors);
    if (!options.report.empty()) fmt::print("report: {}\n", options.report);
    return exit_code(found.verdict.outcome);
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    verb.add_option("images", options->images,
                    "image a and image b, of any renderer; b may be a scene, for its reference")
        ->expected(0, 2);
    verb.add_option("--a", options->a, "independent renders of a: two or more unless a has layers of its variance");
    verb.add_option("--b", options->b, "independent renders of b");
    verb.add_option("--layer-a", options->layer_a, "the layer of a's images, of those with several");
    verb.add_option("--layer-b", options->layer_b, "the layer of b's images");
    verb.add_flag("--exact-b", options->exact_b, "b has no error: a closed form, not a render");
    add_cache(verb, options->cache);
    add_share(verb, "--delta", options->settings.delta, "how far the picture's mean may be off, as a share of b's");
    add_share(verb, "--tile-delta", options->settings.tile_delta,
              "how far a tile's mean may be off, as a share of b's");
    add_share(verb, "--epsilon", options->settings.epsilon,
              "a deviation that is allowed and refutes nothing, as a share of b's mean and of its tiles' and pixels'");
    verb.add_option("--tile", options->settings.tile, "the edge of a tile in pixels; about 256 tiles when not given")
        ->check(CLI::Range(2, 1 << 16));
    verb.add_option("--alpha", options->settings.alpha, "the risk of refuting two true estimates")
        ->check(probability())
        ->capture_default_str();
    verb.add_option("--json", options->json, "write everything but the pixels as JSON to this file");
    verb.add_option("--report", options->report, "the page with both images; '' for none")->capture_default_str();
    verb.footer(
        "Exit code: 0 equal within delta, 1 refuted, 2 usage or input error, 3 undecided. docs/compare.md says what "
        "is\n"
        "tested and what it cannot see.\n\n"
        "Example: plumb compare path.exr bdpt.exr --delta 0.5%");
    return [options](const Catalogue&) { return compare(*options); };
}

}  // namespace

Verb compare() {
    return {"compare", "Decide whether two images estimate the same picture", add};
}

}  // namespace plumb::cli::verbs
