#include "reports/run/html.h"

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

std::string converge_report_html(const RunInfo& run, std::span<const Series> series) {
    return report_html({.run = run, .series = {series.begin(), series.end()}});
}

}  // namespace plumb::reports
