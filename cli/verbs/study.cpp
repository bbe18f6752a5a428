#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/verb.h"
#include "cli/verbs/study_calibration.h"
#include "core/error.h"
#include "core/file.h"
#include "reports/study/study_files.h"
#include "reports/study/study_table.h"
#include "studies/measure.h"
#include "studies/shipped.h"
#include "studies/study_file.h"

namespace plumb::cli::verbs {
namespace {

struct Options {
    std::string study;  ///< a file, or the name of a shipped one
    bool list = false;
    std::optional<std::uint64_t> seed, replicates;  ///< empty: as the study says
    int threads = 0;
    std::optional<std::string> out;  ///< the folder; empty: out/study-NAME; an empty name: none
};

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

int study(const Options& options) {
    if (options.list) return list_studies();
    if (options.study == "calibration")
        return study_calibration({options.seed, options.replicates, options.threads, options.out.value_or("")});
    if (options.study.empty()) throw Error("study: which? Give a TOML file or a name of `plumb study --list`");
    Study study = load(options.study);
    if (options.replicates)
        for (FigurePlan& figure : study.figures) figure.replicates = *options.replicates;

    const std::string folder = options.out.value_or("out/study-" + study.about.name);
    if (!folder.empty()) reports::check_replaceable(folder, {".html", ".csv", ".json", ".svg"});  // before the work

    Session session(options.seed ? options.seed : study.seed, options.threads);
    reports::StudyResult result{.run = {}, .about = study.about, .figures = {}, .headlines = {}};
    const Run run(session.run.seed, "study", 1);
    const auto steps = static_cast<double>(steps_of(study));
    double begun = 0;
    const auto progress = [&](const std::string& what) { session.show(begun++ / steps, what); };
    session.work([&] { result.figures = measure_study(study, run, progress); },
                 folder.empty() ? "nothing is saved" : fmt::format("nothing is saved; {} is as it was", folder));
    result.headlines = measure_headlines(study, result.figures);
    result.run = session.run;
    if (!folder.empty()) reports::write_folder(folder, reports::study_files(result));
    fmt::print("{}{}study: {}{:.1f} s\n", reports::study_table(result, terminal_style()),
               reports::headline_table(result.headlines, terminal_style()),
               folder.empty() ? "" : folder + "/index.html, ", result.run.seconds);
    return 0;
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    verb.add_option("study", options->study, "a TOML file (docs/studies.md), or the name of a shipped study");
    verb.add_flag("--list", options->list, "list the shipped studies instead");
    add_count(verb, "--replicates", options->replicates, 2, 100'000'000,
              "independent runs of each point, in place of the study's own");
    verb.add_option("--out", options->out,
                    "the folder that the study is written to; '' for none; out/study-NAME when not given");
    add_seed_and_threads(verb, options->seed, options->threads);
    verb.footer("Example: plumb study boundary");
    return [options](const Catalogue&) { return study(*options); };
}

}  // namespace

Verb study() {
    return {"study", "Compare estimators as a file says: a page, CSV and SVG", add};
}

}  // namespace plumb::cli::verbs
