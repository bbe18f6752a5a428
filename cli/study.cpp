#include <chrono>
#include <filesystem>

#include "cli/commands.h"
#include "cli/run_info.h"
#include "core/error.h"
#include "core/file.h"
#include "core/parallel.h"
#include "reports/study/study_files.h"
#include "reports/study/study_table.h"
#include "studies/measure.h"
#include "studies/shipped.h"
#include "studies/study_file.h"

namespace plumb::cli {
namespace {

int list_studies() {
    std::vector<reports::ListRow> rows;
    for (const auto& [name, text] : shipped_studies()) {
        const Study study = parse_study(text, std::string(name) + ".toml");
        rows.push_back({{"name", study.about.name},
                        {"figures", static_cast<std::uint64_t>(study.figures.size())},
                        {"source", study.about.source},
                        {"title", study.about.title}});
    }
    rows.push_back({{"name", "calibration"},
                    {"figures", std::uint64_t{0}},
                    {"source", "ours, docs/statistics.md"},
                    {"title", "What a verdict costs, in samples"}});
    fmt::print("{}", reports::list_table(rows, terminal_style()));
    return 0;
}

/// A file when it is written as one (a path, or an ending), else the shipped study of that name.
Study load(const std::string& given) {
    const std::filesystem::path path(given);
    if (path.has_extension() || path.has_parent_path()) return parse_study(read_file(path), given);
    std::vector<std::string> known;
    for (const auto& [name, text] : shipped_studies()) {
        if (name == given) return parse_study(text, given + ".toml");
        known.emplace_back(name);
    }
    known.emplace_back("calibration");
    throw Error(fmt::format("{} (a file of your own ends in .toml)", unknown_name("study", given, known).what()));
}

}  // namespace

int study(const StudyOptions& options) {
    if (options.list) return list_studies();
    if (options.study == "calibration") return study_calibration(options);
    if (options.study.empty()) throw Error("study: which? Give a TOML file or a name of `plumb study --list`");
    Study study = load(options.study);
    if (options.replicates)
        for (FigurePlan& figure : study.figures) figure.replicates = *options.replicates;

    const std::string folder = options.out.empty() ? "out/study-" + study.about.name : options.out;
    reports::check_replaceable(folder, {".html", ".csv", ".json", ".svg"});  // before the work

    reports::StudyResult result{.run = start_run(options.seed ? options.seed : study.seed, options.threads),
                                .about = study.about,
                                .figures = {},
                                .headlines = {}};
    const Run run(result.run.seed, "study", 1);
    const auto start = std::chrono::steady_clock::now();
    {
        ProgressLine line;
        with_threads(result.run.threads, [&] {
            result.figures = measure_study(study, run, [&](const std::string& what) { line.show(what); });
        });
    }
    result.headlines = measure_headlines(study, result.figures);
    result.run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    reports::write_folder(folder, reports::study_files(result));
    fmt::print("{}{}study: {}/index.html, {:.1f} s\n", reports::study_table(result, terminal_style()),
               reports::headline_table(result.headlines, terminal_style()), folder, result.run.seconds);
    return 0;
}

}  // namespace plumb::cli
