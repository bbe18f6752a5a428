#include "reports/run/html.h"

#include "core/file.h"
#include "reports/page/page_html.h"
#include "reports/run/page_data.h"

namespace plumb::reports {
namespace {

std::string title(const Results& results) {
    return results.claims.empty() ? "Plumb: convergence" : "Plumb: " + summary_line(results);
}

}  // namespace

std::string report_html(const Results& results, const std::optional<Results>& against) {
    return page_html(title(results), page_data(results, against));
}

void write_report(const Results& results, const std::optional<Results>& against, const std::filesystem::path& file) {
    write_file(file, report_html(results, against));
}

void write_converge_report(const RunInfo& run, std::span<const Series> series, const std::filesystem::path& file) {
    Results results{.run = run, .series = {series.begin(), series.end()}};
    write_report(results, {}, file);
}

}  // namespace plumb::reports
