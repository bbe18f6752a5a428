#include "reports/html.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <utility>

#include "core/file.h"
#include "reports/page_data.h"
#include "reports/page_files.h"

namespace plumb {
namespace {

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return safe;
}

std::string title(const Results& results) {
    return results.claims.empty() ? "Plumb: convergence" : "Plumb: " + summary_line(results);
}

std::string page_html(std::string_view title, std::string_view data) {
    const std::string heading = escaped(title);
    const std::array<std::pair<std::string_view, std::string_view>, 7> parts = {{{"title", heading},
                                                                                 {"style", page::style()},
                                                                                 {"data", data},
                                                                                 {"licences", page::licences()},
                                                                                 {"d3", page::d3()},
                                                                                 {"plot", page::plot()},
                                                                                 {"script", page::script()}}};
    std::string html;
    std::string_view rest = page::document();
    for (const auto& [name, text] : parts) {  // in the order of the document: what is put in is never searched
        const std::string mark = fmt::format("{{{{{}}}}}", name);
        const std::size_t at = rest.find(mark);
        if (at == std::string_view::npos) throw std::logic_error("page.html has no " + mark);
        html.append(rest.substr(0, at)).append(text);
        rest.remove_prefix(at + mark.size());
    }
    return html.append(rest);
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
