#pragma once

#include <string>
#include <vector>

namespace plumb::reports {

struct SeriesSymbol {
    std::string name;  ///< of Observable Plot
    std::string path;  ///< of SVG, about the origin
};

/// Colours and symbols of the lines of figures, for the page and for plots as files: reports/page/series_styles.json.
struct SeriesStyles {
    std::vector<std::string> light, dark;  ///< colours on paper and on a dark page, as many of each
    std::vector<SeriesSymbol> symbols;
};
const SeriesStyles& series_styles();

/// The colours as the page's style names them: --series-0, --series-1, …
std::string series_css();

}  // namespace plumb::reports
