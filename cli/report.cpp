#include "cli/commands.h"
#include "cli/run_info.h"
#include "core/error.h"
#include "core/file.h"
#include "reports/run/differences.h"
#include "reports/run/html.h"
#include "reports/run/store.h"
#include "reports/run/table.h"

namespace plumb {

int report(const ReportOptions& options) {
    const Store store(options.store, Store::Access::read);
    const std::vector<StoredRun> runs = store.runs();
    if (runs.empty()) throw Error(fmt::format("{}: no run is stored; `plumb verify` stores one", options.store));
    if (options.list) {
        fmt::print("{}", runs_table(runs, terminal_style()));
        return 0;
    }
    check_writable(options.report);
    const Results results = store.load(options.run.value_or(runs.back().id));
    std::optional<Results> against;
    if (options.against) against = store.load(*options.against);
    write_report(results, against, options.report);
    if (against) fmt::print("{}", differences_table(diff_runs(*against, results), terminal_style()));
    if (!results.run.finished)
        fmt::print("unfinished: {} verdicts so far\n", results.claims.size() + results.mutants.size());
    fmt::print("{}\nreport: {}\n", summary_line(results), options.report);
    return 0;
}

}  // namespace plumb
