#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/common_options.h"
#include "cli/session.h"
#include "cli/verb.h"
#include "core/error.h"
#include "core/shard.h"
#include "reports/study/folder.h"
#include "reports/study/study_files.h"
#include "studies/reproduction.h"

namespace plumb::cli::verbs {
namespace {

struct Options {
    std::vector<std::string> patterns, with;  ///< with: stores of other shards
    bool full = false, resume = false;
    std::optional<std::uint64_t> seed;
    int threads = 0;
    Shard shard;
    std::string store = "out/reproduce.db", out = "out/reproduce";
};

int reproduce(Options options) {
    if (options.resume) {
        const reports::RunInfo newest = newest_reproduction(options.store);
        options.seed = newest.seed;
        options.full = newest.size == "full";
    }
    const auto tasks = shipped_figure_tasks(options.full ? Size::full : Size::quick, options.patterns);
    reports::check_replaceable(options.out, {".html", ".csv", ".json", ".svg"});  // before the work

    Session session(options.seed, options.threads);
    session.run.size = options.full ? "full" : "quick";
    std::vector<std::filesystem::path> stores(options.with.begin(), options.with.end());
    session.work([&] {
        measure_missing(tasks, options.shard, session.run, options.store, stores,
                        [&](const std::string& what) { session.show(what); });
    });
    stores.emplace_back(options.store);
    const Reproduction whole = gather(tasks, session.run, stores);
    reports::write_folder(options.out, reports::study_files(whole.result));
    fmt::print("{}", reports::headline_table(whole.result.headlines, terminal_style()));
    if (!whole.missing.empty())
        fmt::print("not measured yet, by this shard or those of --with: {}\n", fmt::join(whole.missing, ", "));
    fmt::print("reproduce: {}/index.html, figures in {}, seed {}, {:.1f} s\n", options.out, options.store,
               session.run.seed, session.run.seconds);
    return 0;
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    verb.add_option("patterns", options->patterns, "of studies or STUDY/FIGURE, with * and ?; all when none is given");
    CLI::Option* full = verb.add_flag("--full", options->full, "the replicates that each study asks for, not a tenth");
    add_seed_and_threads(verb, options->seed, options->threads);
    CLI::Option* seed = verb.get_option("--seed");
    CLI::Option* shard = add_parsed(verb, "--shard", options->shard, parse_shard,
                                    "measure the i-th of n parts of the figures, i/n. Needs --seed")
                             ->needs(seed);
    verb.add_option("--with", options->with, "stores of other shards, whose figures count as measured");
    CLI::Option* resume = verb.add_flag("--resume", options->resume, "go on with the store's newest seed and size");
    for (CLI::Option* setting : {full, seed, shard}) resume->excludes(setting);
    verb.add_option("--store", options->store, "where measured figures are kept")->capture_default_str();
    verb.add_option("--out", options->out, "the folder that the page is written to")->capture_default_str();
    verb.footer(
        "Exit code: 0 whatever is met or not, as that is a fact about the papers; 2 usage or input error.\n\n"
        "Example: plumb reproduce 'yakowitz' 'sequences/one-*'");
    return [options](const Catalogue&) { return reproduce(*options); };
}

}  // namespace

Verb reproduce() {
    return {"reproduce", "Lay what papers promise against what is measured: one page", add};
}

}  // namespace plumb::cli::verbs
