#include "cli/commands.h"
#include "cli/run_info.h"
#include "core/error.h"
#include "core/file.h"
#include "reports/run/differences.h"
#include "reports/run/html.h"
#include "reports/run/store.h"
#include "reports/run/table.h"

namespace plumb::cli {

int report(const ReportOptions& options) {
    const reports::Store store(options.store, reports::Store::Access::read);
    const std::vector<reports::StoredRun> runs = store.runs();
    if (runs.empty()) throw Error(fmt::format("{}: no run is stored; `plumb verify` stores one", options.store));
    if (options.list) {
        fmt::print("{}", reports::runs_table(runs, terminal_style()));
        return 0;
    }
    check_writable(options.report);
    const reports::Results results = store.load(options.run.value_or(runs.back().id));
    std::optional<reports::Results> against;
    if (options.against) against = store.load(*options.against);
    reports::write_report(results, against, options.report);
    if (against) fmt::print("{}", reports::differences_table(reports::diff_runs(*against, results), terminal_style()));
    if (!results.run.finished)
        fmt::print("unfinished: {} verdicts so far\n", results.claims.size() + results.mutants.size());
    fmt::print("{}\nreport: {}\n", reports::summary_line(results), options.report);
    return 0;
}

}  // namespace plumb::cli
