#include "reports/page/page_template.h"

#include <fmt/format.h>

#include <stdexcept>

namespace plumb::reports {

std::string filled(std::string_view document, const std::vector<std::pair<std::string, std::string_view>>& parts) {
    std::string html;
    for (const auto& [name, text] : parts) {
        const std::string mark = fmt::format("{{{{{}}}}}", name);
        const std::size_t at = document.find(mark);
        if (at == std::string_view::npos) throw std::logic_error("the page has no " + mark);
        html.append(document.substr(0, at)).append(text);
        document.remove_prefix(at + mark.size());
    }
    return html.append(document);
}

}  // namespace plumb::reports
