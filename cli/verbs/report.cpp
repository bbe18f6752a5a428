#include <CLI/CLI.hpp>

#include "cli/session.h"
#include "cli/verb.h"
#include "core/error.h"
#include "core/file.h"
#include "reports/run/differences.h"
#include "reports/run/html.h"
#include "reports/run/store.h"
#include "reports/run/table.h"

namespace plumb::cli::verbs {
namespace {

struct Options {
    std::string store = "out/results.db", report = "out/report.html";
    std::optional<std::int64_t> run, against;  ///< run: empty for the newest
    bool list = false;
};

// What the page shows unless told otherwise: a reproduction has a page of its own.
std::int64_t newest(const std::vector<reports::StoredRun>& runs) {
    const auto judging = std::find_if(runs.rbegin(), runs.rend(),
                                      [](const reports::StoredRun& stored) { return judges_claims(stored.run); });
    return (judging == runs.rend() ? runs.rbegin() : judging)->id;
}

int report(const Options& options) {
    const reports::Store store(options.store, reports::Store::Access::read);
    const std::vector<reports::StoredRun> runs = store.runs();
    if (runs.empty()) throw Error(fmt::format("{}: no run is stored; `plumb verify` stores one", options.store));
    if (options.list) {
        fmt::print("{}", reports::runs_table(runs, terminal_style()));
        return 0;
    }
    require_writable({options.report});
    const reports::Results results = store.load(options.run.value_or(newest(runs)));
    std::optional<reports::Results> against;
    if (options.against) against = store.load(*options.against);
    if (!options.report.empty()) write_output(options.report, reports::report_html(results, against));
    if (against) fmt::print("{}", reports::differences_table(reports::diff_runs(*against, results), terminal_style()));
    if (!results.run.finished)
        fmt::print("unfinished: {} verdicts so far\n", results.claims.size() + results.mutants.size());
    fmt::print("{}\n", reports::summary_line(results));
    if (!options.report.empty()) fmt::print("report: {}\n", options.report);
    return 0;
}

Action add(CLI::App& verb) {
    const auto options = std::make_shared<Options>();
    verb.add_option("--run", options->run, "the run's number; the newest that judged claims when not given");
    verb.add_option("--against", options->against, "another run: show what changed since");
    verb.add_flag("--list", options->list, "list the stored runs instead");
    verb.add_option("--store", options->store, "the SQLite store that holds the runs")->capture_default_str();
    verb.add_option("--report", options->report, "the HTML page to write; '' for none")->capture_default_str();
    verb.footer("Example: plumb report --run 12 --against 11");
    return [options](const Catalogue&) { return report(*options); };
}

}  // namespace

Verb report() {
    return {"report", "Rebuild the report of a stored run", add};
}

}  // namespace plumb::cli::verbs
