#include <CLI/CLI.hpp>
#include <functional>

#include "analytic/any_integrand.h"
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
#include "reports/study/study_files.h"
#include "reports/study/study_page.h"
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
    std::vector<std::string> images;  ///< patterns of files that somebody has, instead of estimators and integrands
    std::string reference;  ///< of a scene: a file, "auto" for the cached one; empty: measured for the purpose
    std::string cache = "out/references";
    std::string csv, svg;  ///< of images
    std::string json, report = "out/converge.html";
};

/// Measures all estimators on what --on names; of a scene it says what the errors are measured against. `progress` is
/// told the share that is done and what comes next.
using Progress = std::function<void(double share, const std::string& next)>;
using Measurement =
    std::function<std::vector<Series>(const Run& run, std::vector<std::string>& truths, const Progress& progress)>;

template <int D>
Measurement on_integrand(const Options& options, const Integrand<D>& f) {
    if (!options.reference.empty())
        throw Error(fmt::format("--reference for '{}'; accepted are scenes, and --images", f.id));
    std::vector<const Estimator<D>*> estimators;
    for (const std::string& id : options.estimators) estimators.push_back(&find_estimator<D>(id));
    return [&options, &f, estimators](const Run& run, std::vector<std::string>&, const Progress& progress) {
        std::vector<Series> series;
        for (const Estimator<D>* estimator : estimators) {
            const double share = static_cast<double>(series.size()) / static_cast<double>(estimators.size());
            progress(share, fmt::format("{} on {}", estimator->id, f.id));
            series.push_back(measure_series(*estimator, f, options.n, options.replicates, run));
        }
        return series;
    };
}

Measurement on_scene(const Options& options, const ScenePart& part) {
    SceneMeasure measure{{}, options.n, options.replicates, options.reference, options.cache};
    for (const std::string& id : options.estimators) measure.methods.push_back(scene_method(id));
    const std::string names = fmt::format("{}", fmt::join(options.estimators, ", "));
    return [part, measure, names](const Run& run, std::vector<std::string>& truths, const Progress& progress) {
        progress(0, fmt::format("{} on {}", names, part.id));
        SceneSeries measured = measure_scene(part, measure, run);
        truths.push_back(fmt::format("{}: {}", part.id, measured.said));
        return std::move(measured.series);
    };
}

/// Every name is looked up, and every scene loaded, before the first sample is drawn.
std::vector<Measurement> measurements(const Options& options) {
    LoadedScenes scenes({.lenient = true});
    std::vector<Measurement> all;
    for (const std::string& on : options.integrands) {
        const auto part = known_integrand(on) ? std::nullopt : scene_part(on, scenes);
        all.push_back(
            part ? on_scene(options, *part)
                 : std::visit([&](const auto* f) { return on_integrand(options, *f); }, find_any_integrand(on)));
    }
    return all;
}

// The one plot among the files of a study.
std::string svg_of(const reports::StudyResult& figure) {
    const std::vector<reports::FolderFile> files = reports::study_files(figure);
    return std::ranges::find_if(files, [](const auto& file) { return file.name.ends_with(".svg"); })->text;
}

// Of images that somebody has, in place of estimators and integrands.
int converge_images(const Options& options) {
    require_writable({options.json, options.csv, options.svg, options.report});
    std::vector<ImageSeries> measured;
    std::vector<Series> all;
    std::vector<std::string> truths;
    for (const std::string& pattern : options.images) {
        measured.push_back(measure_images(pattern, options.reference));
        all.push_back(measured.back().series);
        truths.push_back(measured.back().said);
    }
    const reports::StudyResult figure = figure_of(measured, Session(0, options.threads).run);
    if (!options.json.empty()) write_output(options.json, reports::converge_json(figure.run, all, truths));
    if (!options.csv.empty()) write_output(options.csv, csv_of(measured));
    if (!options.svg.empty()) write_output(options.svg, svg_of(figure));
    if (!options.report.empty()) write_output(options.report, reports::study_html(figure));
    for (const ImageSeries& one : measured)
        fmt::print("{}{}truth of {}\n", measured.size() > 1 ? one.series.estimator + "\n" : "",
                   text_of(one, terminal_style().width), one.said);
    if (!options.report.empty()) fmt::print("report: {}\n", options.report);
    return 0;
}

int converge(const Options& options) {
    if (!options.images.empty()) return converge_images(options);
    if (options.estimators.empty() || options.integrands.empty())
        throw Error("converge: what? Give estimators and --on, or --images and --reference");
    const std::vector<Measurement> all = measurements(options);
    require_writable({options.json, options.report});
    Session session(options.seed, options.threads);
    const Run run(session.run.seed, "converge", 1);
    std::vector<Series> series;
    std::vector<std::string> truths;
    session.work([&] {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto progress = [&](double share, const std::string& next) {
                session.show((static_cast<double>(i) + share) / static_cast<double>(all.size()), next);
            };
            for (Series& one : all[i](run, truths, progress)) series.push_back(std::move(one));
        }
    });
    if (!options.json.empty()) write_output(options.json, reports::converge_json(session.run, series, truths));
    if (!options.report.empty()) write_output(options.report, reports::converge_report_html(session.run, series));
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
                        "instead: the error of images that you have, 'out_{spp}_{seed}.exr'; {seconds} too, if known; "
                        "several patterns share one plot")
            ->excludes(estimators)
            ->excludes(on);
    verb.add_option("--reference", options->reference,
                    "the truth: an image, or auto for the cached one of a scene; measured when not given");
    add_cache(verb, options->cache);
    add_parsed(verb, "--n", options->n, parse_sample_counts, "sample counts: first..last (doubling) or a list a,b,c")
        ->default_str(default_counts);
    add_count(verb, "--replicates", options->replicates, 2, 100'000'000, "independent runs at each count");
    add_seed_and_threads(verb, options->seed, options->threads);
    for (const char* other : {"--cache", "--n", "--replicates", "--seed"}) images->excludes(verb.get_option(other));
    verb.add_option("--json", options->json, "write the series as JSON to this file");
    verb.add_option("--csv", options->csv, "write the series of --images as CSV to this file")->needs(images);
    verb.add_option("--svg", options->svg, "draw relMSE of --images against samples to this file")->needs(images);
    verb.add_option("--report", options->report, "the page with the plots; '' for none")->capture_default_str();
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
