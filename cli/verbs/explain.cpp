#include <CLI/CLI.hpp>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/verb.h"
#include "cli/verbs/explain/explanation.h"
#include "cli/verbs/explain/picture.h"
#include "cli/verbs/path_options.h"
#include "core/error.h"
#include "core/parallel.h"
#include "integrators/references/scene_identity.h"
#include "reports/run/json.h"

namespace plumb::cli::verbs {
namespace {

/// One path of a render, or the brightest one of a pixel.
struct Options : PathOptions {
    std::optional<int> x, y;              ///< of the pixel
    std::optional<std::uint32_t> sample;  ///< empty: the brightest
    std::uint32_t replicates = 0;         ///< passes of the render; 0: as `render --spp` cuts them
    bool fireflies = false;               ///< the pixels that stand out instead
    std::string json;
    std::vector<std::string> given;  ///< options that a picture says itself
};

// What is explained: a render of this scene by this method.
struct Subject {
    LoadedScene scene;
    RenderMethod method;
    RenderSettings settings;
};

// Sets of points, of sobol and stratified samples, are as long as a pass.
void cut(RenderSettings& settings, std::uint64_t samples, std::uint64_t passes) {
    if (passes == 0 || samples % passes != 0)
        throw Error(
            fmt::format("{} samples a pixel in {} replicates: accepted are divisors of the samples", samples, passes));
    settings.passes = static_cast<std::uint32_t>(passes);
    settings.samples_per_pass = static_cast<std::uint32_t>(samples / passes);
}

Subject subject_of(const Options& options) {
    ReadScene read = read_scene(options.scene, options.load);
    const RenderMethod method = method_of(options, read.description);
    LoadedScene scene = made_ready(std::move(read));
    RenderSettings settings = settings_of(options, Session(options.seed, 1).run.seed, scene.scene.sensor().film());
    if (options.replicates > 0) cut(settings, options.samples_per_pixel, options.replicates);
    return {std::move(scene), method, settings};
}

// As the picture says it was made.
Subject subject_of(const Options& options, const TellingPicture& picture) {
    const Provenance& said = picture.said;
    if (!options.given.empty())
        throw Error(fmt::format("{} says {} itself: it cannot be given", picture.file, fmt::join(options.given, ", ")));
    LoadedScene scene = load_scene(said.scene, options.load);
    require_same_scene(said, identity_of(scene), picture.file);
    RenderSettings settings{.seed = said.seed, .crop = said.crop};
    cut(settings, said.samples_per_pixel, said.replicates);
    return {std::move(scene), resolved({said.integrator, said.driver, said.sampler, said.limits, said.parameters}),
            settings};
}

// The samples of a pixel, brightest first, by what they add to it.
struct Ranked {
    std::uint32_t sample;
    double brightness;
};
std::vector<Ranked> ranked(const RenderJob& job, int x, int y) {
    std::vector<Ranked> all(job.settings.passes * std::size_t{job.settings.samples_per_pass});
    for_batches(all.size(), [&](std::size_t i) {
        const auto sample = static_cast<std::uint32_t>(i);
        all[i] = {sample, luminance(explain(job, x, y, sample).value)};
    });
    std::ranges::stable_sort(all, std::greater<>(), &Ranked::brightness);
    return all;
}

std::string text_of(const std::vector<Ranked>& samples, int x, int y) {
    double sum = 0;
    for (const Ranked& one : samples) sum += one.brightness;
    std::string text = fmt::format("pixel {},{}: of {} samples the brightest are", x, y, samples.size());
    for (std::size_t i = 0; i < std::min<std::size_t>(5, samples.size()); ++i)
        text += fmt::format("{} {} ({:.3g} % of the pixel)", i ? "," : "", samples[i].sample,
                            sum > 0 ? 100 * samples[i].brightness / sum : 0);
    return text + "\n";
}

int list_fireflies(const TellingPicture& picture, const RenderJob& job) {
    std::vector<reports::ListRow> rows;
    for (const Firefly& pixel : fireflies(picture, 8)) {
        const std::vector<Ranked> samples = ranked(job, pixel.x, pixel.y);
        double sum = 0;
        for (const Ranked& one : samples) sum += one.brightness;
        rows.push_back({{"x", static_cast<std::uint64_t>(pixel.x)},
                        {"y", static_cast<std::uint64_t>(pixel.y)},
                        {"luminance", pixel.luminance},
                        {"neighbours", pixel.neighbours},
                        {"brightest_sample", std::uint64_t{samples.front().sample}},
                        {"its_share", sum > 0 ? samples.front().brightness / sum : 0}});
    }
    fmt::print("{}`plumb explain {} {} {}` tells the brightest sample of the first\n",
               reports::list_table(rows, terminal_style()), picture.file, std::get<std::uint64_t>(rows[0][0].second),
               std::get<std::uint64_t>(rows[0][1].second));
    return 0;
}

int explain(const Options& options) {
    require_writable({options.json});
    const auto picture = telling_picture(options.scene);
    if (options.fireflies && !picture) throw Error("--fireflies is for a picture that plumb render wrote");
    if (!options.fireflies && (!options.x || !options.y)) throw Error("explain: which pixel? Give x and y");
    const auto& [scene, method, settings] = picture ? subject_of(options, *picture) : subject_of(options);
    const auto estimator = estimator_of(method);
    const RenderJob job = job_of(method, scene.scene, *estimator, settings);
    if (options.fireflies) return list_fireflies(*picture, job);

    const int x = *options.x, y = *options.y;
    std::uint32_t index = options.sample.value_or(0);
    if (!options.sample) {
        const std::vector<Ranked> samples = ranked(job, x, y);
        index = samples.front().sample;
        fmt::print("{}", text_of(samples, x, y));
    }
    const Explanation told = explain(job, x, y, index);
    const ExplainedSample sample{scene, method, job.settings, x, y, index, told};
    if (!options.json.empty()) write_output(options.json, explanation_json(sample));
    fmt::print("{}", explanation_text(sample));
    return 0;
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    add_paths(verb, *options);
    verb.get_option("scene")->description(
        "a scene in Mitsuba's XML, the name of a shipped one, or a picture that plumb render wrote, which says all "
        "options itself");
    CLI::Option* x = verb.add_option("x", options->x, "the pixel's column, 0 at the left");
    verb.add_option("y", options->y, "the pixel's row, 0 at the top");
    verb.add_option("sample", options->sample,
                    "which of the pixel's samples, 0 to spp - 1; the brightest when not given");
    verb.add_flag("--fireflies", options->fireflies, "list the pixels of a picture that stand out instead")
        ->excludes(x);
    add_count(verb, "--replicates", options->replicates, 1, 1u << 24,
              "passes of the render, where --spp did not set them: give spp and replicates as the image's metadata do")
        ->default_str("");
    add_seed(verb, options->seed);
    verb.add_option("--json", options->json, "write all of it as JSON to this file, every number to the bit");
    verb.footer(
        "The path is that of plumb render with the same options: give it the seed of the image, or the image.\n\n"
        "Examples: plumb explain cornell_box 64 100 3 --integrator path --seed 7\n"
        "          plumb explain out/cornell_box.exr --fireflies\n"
        "          plumb explain out/cornell_box.exr 64 100");
    return [options, &verb](const Catalogue&) {
        for (const char* name : {"--integrator", "--driver", "--sampler", "-P", "--max-depth", "--rr-depth", "--length",
                                 "--strategy", "--spp", "--crop", "--seed", "--replicates"})
            if (verb.get_option(name)->count() > 0) options->given.emplace_back(name);
        return explain(*options);
    };
}

}  // namespace

Verb explain() {
    return {"explain", "Explain one path of a render: vertices, densities, weights, splats", add};
}

}  // namespace plumb::cli::verbs
