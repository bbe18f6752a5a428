#include "reports/html.h"

#include <fmt/format.h>

#include "core/file.h"
#include "reports/page_data.h"
#include "reports/page_files.h"
#include "reports/page_template.h"

namespace plumb {
namespace {

std::string title(const Results& results) {
    return results.claims.empty() ? "Plumb: convergence" : "Plumb: " + summary_line(results);
}

std::string page_html(std::string_view title, std::string_view data) {
    const std::string heading = escaped(title);
    return filled(page::document(), {{"title", heading},
                                     {"style", page::style()},
                                     {"data", data},
                                     {"licences", page::licences()},
                                     {"d3", page::d3()},
                                     {"plot", page::plot()},
                                     {"script", page::script()}});
}

}  // namespace

std::string report_html(const Results& results, const std::optional<Results>& against) {
    return page_html(title(results), page_data(results, against));
}

std::string study_html(const StudyResult& study) {
    return page_html("Plumb study: " + study.about.title, page_data(study));
}

void write_report(const Results& results, const std::optional<Results>& against, const std::filesystem::path& file) {
    write_file(file, report_html(results, against));
}

void write_converge_report(const RunInfo& run, std::span<const Series> series, const std::filesystem::path& file) {
    Results results{.run = run, .series = {series.begin(), series.end()}};
    write_report(results, {}, file);
}

}  // namespace plumb
