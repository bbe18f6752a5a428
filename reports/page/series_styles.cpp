#include "reports/page/series_styles.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/page/page_files.h"

namespace plumb::reports {
namespace {

std::string variables(const std::vector<std::string>& colours) {
    std::string css;
    for (std::size_t i = 0; i < colours.size(); ++i) css += fmt::format(" --series-{}: {};", i, colours[i]);
    return css;
}

}  // namespace

const SeriesStyles& series_styles() {
    static const SeriesStyles styles = [] {
        const auto json = nlohmann::json::parse(page::series_styles());
        SeriesStyles read{json.at("light"), json.at("dark"), {}};
        for (const auto& symbol : json.at("symbols")) read.symbols.push_back({symbol.at("name"), symbol.at("path")});
        return read;
    }();
    return styles;
}

std::string series_css() {
    return fmt::format(":root {{{} }}\n@media (prefers-color-scheme: dark) {{ :root {{{} }} }}\n",
                       variables(series_styles().light), variables(series_styles().dark));
}

}  // namespace plumb::reports
