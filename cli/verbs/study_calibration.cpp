#include "cli/verbs/study_calibration.h"

#include <filesystem>

#include "cli/session.h"
#include "core/file.h"
#include "reports/run/json.h"
#include "reports/text/text.h"
#include "verification/evidence/cost_of_a_verdict.h"

namespace plumb::cli {
namespace {

std::string markdown(const std::vector<CostOfAVerdict>& rows, const CostSetting& setting) {
    std::string text = fmt::format(
        "Samples of a mean verdict, sigma/delta = {:g}, alpha = {:.2g}, beta = {:g}; the fixed design with these risks "
        "takes {:.0f}.\n\n"
        "| bias/delta | samples | of the fixed design | Wald's bound | holds | refuted | undecided | 1e5 samples, 1 % "
        "test "
        "rejects | 1e6 samples |\n|---|---|---|---|---|---|---|---|---|\n",
        1 / CostSetting::delta_over_sigma, setting.alpha, setting.beta, fixed_design(setting));
    for (const CostOfAVerdict& row : rows)
        text += fmt::format(
            "| {:g} | {:.0f} ± {:.0f} | {:.3g} | {} | {:.1f} % | {:.1f} % | {:.1f} % | {:.1f} % | {:.1f} % |\n",
            row.bias, row.mean_samples, row.standard_error, row.fraction, reports::readable(row.wald), 100 * row.holds,
            100 * row.refuted, 100 * row.undecided, 100 * row.fixed_1e5, 100 * row.fixed_1e6);
    return text;
}

std::string json(const std::vector<CostOfAVerdict>& rows) {
    std::vector<reports::ListRow> objects;
    for (const CostOfAVerdict& row : rows)
        objects.push_back({{"bias_over_delta", row.bias},
                           {"samples", row.mean_samples},
                           {"samples_standard_error", row.standard_error},
                           {"of_fixed_design", row.fraction},
                           {"wald_bound", row.wald},
                           {"holds", row.holds},
                           {"refuted", row.refuted},
                           {"undecided", row.undecided},
                           {"fixed_1e5_rejects", row.fixed_1e5},
                           {"fixed_1e6_rejects", row.fixed_1e6}});
    return reports::list_json(objects);
}

}  // namespace

int study_calibration(const CalibrationStudy& options) {
    CostSetting setting;
    if (options.replicates) setting.replicates = *options.replicates;
    const std::filesystem::path folder = options.out.empty() ? "out/study-calibration" : options.out;
    Session session(options.seed, options.threads);
    std::vector<CostOfAVerdict> rows;
    session.work(
        [&] {
            rows =
                cost_of_a_verdict(setting, {0, 0.5, 1, 1.5, 2, 5, 10}, Run(session.run.seed, "study calibration", 1));
        },
        fmt::format("nothing is saved; {} is as it was", folder.string()));
    const std::string table = markdown(rows, setting);
    write_file(folder / "cost.md", table);
    write_file(folder / "cost.json", json(rows));
    fmt::print("{}study: {}, seed {}\n", table, (folder / "cost.md").string(), session.run.seed);
    return 0;
}

}  // namespace plumb::cli
