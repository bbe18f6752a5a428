#include <chrono>

#include "analytic/integrand.h"
#include "cli/commands.h"
#include "cli/converge_images.h"
#include "cli/run_info.h"
#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"
#include "estimators/estimator.h"
#include "reports/run/html.h"
#include "reports/run/json.h"
#include "reports/run/table.h"
#include "studies/measure.h"
#include "studies/scene_series.h"

namespace plumb::cli {
namespace {

Series measure_any(const std::string& estimator, const std::string& integrand, const ConvergeOptions& options,
                   const Run& run) {
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
void check_names(const ConvergeOptions& options) {
    ConvergeOptions nothing = options;
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

std::vector<Series> measure_all(const std::string& on, const ConvergeOptions& options, const Run& run,
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

}  // namespace

int converge(const ConvergeOptions& options) {
    if (!options.images.empty()) return converge_images(options);
    if (options.estimators.empty() || options.integrands.empty())
        throw Error("converge: what? Give estimators and --on, or --images and --reference");
    check_names(options);
    for (const std::string& file : {options.json, options.report})
        if (!file.empty()) check_writable(file);
    reports::RunInfo info = start_run(options.seed, options.threads);
    const Run run(info.seed, "converge", 1);
    const auto start = std::chrono::steady_clock::now();
    std::vector<Series> series;
    std::vector<std::string> truths;
    {
        ProgressLine line;
        with_threads(info.threads, [&] {
            for (const std::string& on : options.integrands) {
                line.show(fmt::format("{} on {}", fmt::join(options.estimators, ", "), on));
                for (Series& one : measure_all(on, options, run, truths)) series.push_back(std::move(one));
            }
        });
    }
    info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!options.json.empty()) write_file(options.json, reports::converge_json(info, series, truths));
    if (!options.report.empty()) reports::write_converge_report(info, series, options.report);
    fmt::print("{}", reports::converge_table(series, terminal_style()));
    for (const std::string& truth : truths) fmt::print("truth of {}\n", truth);
    if (!options.report.empty()) fmt::print("report: {}\n", options.report);
    return 0;
}

}  // namespace plumb::cli
