#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/values.h"
#include "cli/verb.h"
#include "cli/verbs/exit_code.h"
#include "core/error.h"
#include "core/file.h"
#include "core/images/image.h"
#include "core/images/layers.h"
#include "integrators/references/provenance.h"
#include "reports/images/known_values.h"
#include "scenes/shipped/known_radiances.h"
#include "scenes/shipped/shipped.h"

namespace plumb::cli::verbs {
namespace {

struct Options {
    std::vector<std::string> images;  ///< independent renders of one picture
    std::string expected;             ///< a file, or the name of a shipped scene
    std::optional<int> edges;         ///< of the longest paths that count; 0: all do; empty: as the images say
    std::string layer;                ///< of the images; empty: the picture itself, or the only one
    CheckSettings settings;
    std::string json;
};

namespace fs = std::filesystem;

/// In edges, of the longest path that counts; empty: all light.
using PathLength = std::optional<int>;

std::string text_of(const PathLength& length) {
    return length ? std::to_string(*length) : "all";
}

fs::path expected_file(const std::string& given) {
    const fs::path path(given);
    if (fs::is_regular_file(path) || path.has_extension() || path.has_parent_path()) return path;
    return scene_file(given).parent_path() / "expected.json";
}

PathLength length_of(const Image& image, const std::string& file) {
    const std::optional<Provenance> provenance = provenance_of(image, file);
    if (!provenance)
        throw Error(fmt::format("{}: does not say how long its paths may be; give --edges N, or --edges all", file));
    return longest_path_of(*provenance, file);
}

PathLength length_asked(const Options& options, const std::vector<Image>& images) {
    if (options.edges) return *options.edges > 0 ? options.edges : std::nullopt;
    const PathLength length = length_of(images[0], options.images[0]);
    for (std::size_t i = 1; i < images.size(); ++i)
        if (length_of(images[i], options.images[i]) != length)
            throw Error(
                fmt::format("{} and {} differ in the length of their paths", options.images[0], options.images[i]));
    return length;
}

// One image that does not tell its error is taken as it is: its noise counts as deviation.
Picture picture_to_check(const std::vector<Image>& images, const std::vector<std::string>& files) {
    const bool exact = images.size() == 1 && !has_variance(images[0], files[0]);
    Picture picture = picture_of(images, files, exact);
    if (picture.channels.size() != 3 || picture.channels[0] != "R")
        throw Error(fmt::format("{}: has channels {}; what is known is R, G and B", files[0],
                                fmt::join(picture.channels, ", ")));
    if (exact) fmt::print("{}: has no layers variance.R …: noise counts as deviation\n", files[0]);
    return picture;
}

std::string name_of(const KnownRadiance& known) {
    switch (known.over) {
        case KnownRadiance::Over::point: return fmt::format("point ({:.6g}, {:.6g})", known.film[0], known.film[1]);
        case KnownRadiance::Over::pixel: return fmt::format("pixel ({:.6g}, {:.6g})", known.film[0], known.film[1]);
        case KnownRadiance::Over::film: return "film";
        case KnownRadiance::Over::rectangle: break;
    }
    const FilmBox& box = known.box;
    return fmt::format("{:.6g} x {:.6g} at ({:.6g}, {:.6g})", box.width, box.height, box.x, box.y);
}

std::vector<KnownValue> values_of(const KnownScene& scene, const PathLength& length, const std::string& file) {
    std::vector<KnownValue> values;
    std::vector<std::string> lengths;
    for (const KnownRadiance& known : scene.radiances) {
        if (std::ranges::find(lengths, text_of(known.edges)) == lengths.end()) lengths.push_back(text_of(known.edges));
        if (known.edges != length) continue;
        KnownValue value{.name = name_of(known),
                         .source = known.derivation,
                         .x = known.film[0],
                         .y = known.film[1],
                         .value = {known.value[0], known.value[1], known.value[2]},
                         .error = known.error};
        if (known.over != KnownRadiance::Over::point) {
            value.x = known.box.x + known.box.width / 2;
            value.y = known.box.y + known.box.height / 2;
            value.width = known.box.width;
            value.height = known.box.height;
        }
        values.push_back(std::move(value));
    }
    if (values.empty())
        throw Error(fmt::format("{}: has no radiance by paths of {}; known are {}", file,
                                length ? fmt::format("up to {} edges", *length) : "any length",
                                fmt::join(lengths, ", ")));
    return values;
}

int check(const Options& options) {
    require_writable({options.json});
    const std::string expected = expected_file(options.expected).string();
    const KnownScene scene = known_radiances(expected);
    std::vector<Image> images;
    for (const std::string& file : options.images)
        images.push_back(picture_layer(read_image(file), file, options.layer));
    require_independent(images, options.images);
    if (images[0].width != scene.film.width || images[0].height != scene.film.height)
        throw Error(fmt::format("{}: is {}x{} pixels, the film of {} {}x{}", options.images[0], images[0].width,
                                images[0].height, expected, scene.film.width, scene.film.height));
    const std::vector<KnownValue> known = values_of(scene, length_asked(options, images), expected);
    const Picture picture = picture_to_check(images, options.images);
    const ValuesCheck found = check(picture, known, options.settings);

    const reports::ValuesReport report{options.images, expected, picture, known, options.settings, found};
    if (!options.json.empty()) write_output(options.json, reports::values_json(report));
    fmt::print("{}{}: {}\n", reports::values_table(report, terminal_style()), to_string(found.verdict.outcome),
               found.verdict.reason);
    return exit_code(found.verdict.outcome);
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    verb.add_option("images", options->images, "an image of any renderer, or several independent renders of it")
        ->required();
    verb.add_option("--expect", options->expected, "an expected.json (docs/scenes.md), or the name of a shipped scene")
        ->required();
    verb.add_option("--layer", options->layer, "the layer of the images, of those with several");
    add_parsed(verb, "--edges", options->edges, parse_edges,
               "the longest paths that the image counts: 2 (direct light), or all; Plumb's own images say it "
               "themselves");
    add_share(verb, "--delta", options->settings.delta, "how far a value may be off, as a share of what is known");
    verb.add_option("--alpha", options->settings.alpha, "the risk of refuting an image that is right")
        ->check(probability())
        ->capture_default_str();
    verb.add_option("--json", options->json, "write all values as JSON to this file");
    verb.footer(
        "Exit code: 0 all values are as known, 1 refuted, 2 usage or input error, 3 undecided. See docs/compare.md.\n\n"
        "Example: plumb check render.exr --expect quad_light --edges all");
    return [options](const Catalogue&) { return check(*options); };
}

}  // namespace

Verb check() {
    return {"check", "Hold an image against the radiances that are known of its scene", add};
}

}  // namespace plumb::cli::verbs
