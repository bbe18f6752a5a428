#include "cli/verbs/figure_outputs.h"

#include <fmt/ranges.h>

#include "cli/session.h"
#include "reports/study/folder.h"
#include "reports/study/study_files.h"

namespace plumb::cli {

void check_outputs(const FigureOutputs& outputs) {
    if (!outputs.out.empty()) reports::check_replaceable(outputs.out, {".html", ".csv", ".json", ".svg"});
}

int publish(const std::vector<FigureTask>& tasks, const reports::Results& results, std::int64_t run,
            const FigureOutputs& outputs) {
    const Reproduction whole = gather(tasks, results);
    if (!outputs.out.empty()) reports::write_folder(outputs.out, reports::study_files(whole.result));
    fmt::print("{}", reports::headline_table(whole.result.headlines, terminal_style()));
    if (!whole.missing.empty()) fmt::print("of other shards: {}\n", fmt::join(whole.missing, ", "));
    fmt::print("run {} in {}, seed {}, {:.1f} s{}\n", run, outputs.store, results.run.seed, results.run.seconds,
               outputs.out.empty() ? "" : fmt::format("; page: {}/index.html", outputs.out));
    return 0;
}

}  // namespace plumb::cli
