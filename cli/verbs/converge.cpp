#include <CLI/CLI.hpp>

#include "analytic/integrand.h"
#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/verb.h"
#include "core/error.h"
#include "core/file.h"
#include "core/sample_counts.h"
#include "estimators/estimator.h"
#include "reports/run/html.h"
#include "reports/run/json.h"
#include "reports/run/table.h"
#include "studies/image_series.h"
#include "studies/measure.h"
#include "studies/scene_series.h"

namespace plumb::cli::verbs {
namespace {

constexpr const char* default_counts = "16..4096";

struct Options {
    std::vector<std::string> estimators, integrands;
    std::vector<std::uint64_t> n = parse_sample_counts(default_counts);
    std::uint64_t replicates = 1000;
    std::optional<std::uint64_t> seed;
    int threads = 0;
    std::string images;     ///< a pattern of files that somebody has, instead of estimators and integrands
    std::string reference;  ///< of a scene: a file, "auto" for the cached one; empty: measured for the purpose
    std::string cache = "out/references";
    std::string json, report = "out/converge.html";
};

Series measure_any(const std::string& estimator, const std::string& integrand, const Options& options, const Run& run) {
    const auto& [n, replicates] = std::tie(options.n, options.replicates);
    if (knows_integrand<1>(integrand))
        return measure_series(find_estimator<1>(estimator), find_integrand<1>(integrand), n, replicates, run);
    if (knows_integrand<2>(integrand))
        return measure_series(find_estimator<2>(estimator), find_integrand<2>(integrand), n, replicates, run);
    std::vector<std::string> known;
    for (const auto& f : integrands<1>()) known.push_back(f.id);
    for (const auto& f : integrands<2>()) known.push_back(f.id);
    throw unknown_name("integrand", integrand, known);
}

// Every name is looked up before the first sample is drawn.
void check_names(const Options& options) {
    Options nothing = options;
    nothing.n.clear();
    const Run run(0, "names", 1);
    for (const std::string& on : options.integrands) {
        if (names_scene(on)) {
            check_scene_methods(options.estimators);
            continue;
        }
        if (!options.reference.empty())
            throw Error(fmt::format("--reference for '{}'; accepted are scenes, and --images", on));
        for (const std::string& estimator : options.estimators) measure_any(estimator, on, nothing, run);
    }
}

std::vector<Series> measure_all(const std::string& on, const Options& options, const Run& run,
                                std::vector<std::string>& truths) {
    if (names_scene(on)) {
        SceneSeries measured = measure_scene(
            on, {options.estimators, options.n, options.replicates, options.reference, options.cache}, run);
        truths.push_back(fmt::format("{}: {}", on, measured.said));
        return std::move(measured.series);
    }
    std::vector<Series> series;
    for (const std::string& estimator : options.estimators) series.push_back(measure_any(estimator, on, options, run));
    return series;
}

// Of images that somebody has, in place of estimators and integrands.
int converge_images(const Options& options) {
    require_writable({options.json, options.report});
    const ImageSeries measured = measure_images(options.images, options.reference);
    const reports::RunInfo info = Session(0, options.threads).run;
    const std::vector<Series> all{measured.series};
    if (!options.json.empty()) write_file(options.json, reports::converge_json(info, all, std::vector{measured.said}));
    if (!options.report.empty()) reports::write_converge_report(info, all, options.report);
    fmt::print("{}truth of {}\n", text_of(measured, terminal_style().width), measured.said);
    if (!options.report.empty()) fmt::print("report: {}\n", options.report);
    return 0;
}

int converge(const Options& options) {
    if (!options.images.empty()) return converge_images(options);
    if (options.estimators.empty() || options.integrands.empty())
        throw Error("converge: what? Give estimators and --on, or --images and --reference");
    check_names(options);
    require_writable({options.json, options.report});
    Session session(options.seed, options.threads);
    const Run run(session.run.seed, "converge", 1);
    std::vector<Series> series;
    std::vector<std::string> truths;
    session.work([&] {
        for (const std::string& on : options.integrands) {
            session.show(fmt::format("{} on {}", fmt::join(options.estimators, ", "), on));
            for (Series& one : measure_all(on, options, run, truths)) series.push_back(std::move(one));
        }
    });
    if (!options.json.empty()) write_file(options.json, reports::converge_json(session.run, series, truths));
    if (!options.report.empty()) reports::write_converge_report(session.run, series, options.report);
    fmt::print("{}", reports::converge_table(series, terminal_style()));
    for (const std::string& truth : truths) fmt::print("truth of {}\n", truth);
    if (!options.report.empty()) fmt::print("report: {}\n", options.report);
    return 0;
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    CLI::Option* estimators = verb.add_option(
        "estimators", options->estimators,
        "what to measure, e.g. independent torus-tent, or on scenes direct, direct+sobol; see plumb list");
    CLI::Option* on =
        verb.add_option("--on", options->integrands,
                        "what they estimate: integrands, e.g. exp, or scenes: SCENE, SCENE:x,y (a pixel), "
                        "SCENE:x,y,width,height");
    CLI::Option* images =
        verb.add_option("--images", options->images,
                        "instead: the error of images that you have, 'out_{spp}_{seed}.exr'; {seconds} too, if known")
            ->excludes(estimators)
            ->excludes(on);
    verb.add_option("--reference", options->reference,
                    "the truth: an image, or auto for the cached one of a scene; measured when not given");
    add_cache(verb, options->cache);
    add_parsed(verb, "--n", options->n, parse_sample_counts, "sample counts: first..last (doubling) or a list a,b,c")
        ->default_str(default_counts);
    verb.add_option("--replicates", options->replicates, "independent runs at each count")
        ->check(CLI::Range(2, 100'000'000))
        ->capture_default_str();
    add_seed_and_threads(verb, options->seed, options->threads);
    for (const char* other : {"--cache", "--n", "--replicates", "--seed"}) images->excludes(verb.get_option(other));
    verb.add_option("--json", options->json, "write the series as JSON to this file");
    verb.add_option("--report", options->report, "the page with the plots")->capture_default_str();
    verb.footer(
        "Examples: plumb converge independent torus-tent --on exp --n 16..4096\n"
        "          plumb converge direct direct+sobol --on cornell_box:64,64\n"
        "          plumb converge --images 'out_{spp}_{seed}.exr' --reference ref.exr");
    return [options](const Catalogue&) { return converge(*options); };
}

}  // namespace

Verb converge() {
    return {"converge", "Measure error against samples, evaluations and seconds", add};
}

}  // namespace plumb::cli::verbs
