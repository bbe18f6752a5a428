#pragma once

#include <string_view>

// The files of reports/page/ and the chart library from its node_modules, as they were when the library was built.
namespace plumb::reports::page {

std::string_view document();  ///< page.html, with {{style}} and the like where the others go
std::string_view style();
std::string_view series_styles();  ///< JSON
std::string_view bibliography();   ///< docs/sources.md
std::string_view d3();
std::string_view plot();
std::string_view script();                                                        ///< all of page/script/
std::string_view comparison_document(), comparison_style(), comparison_script();  ///< likewise, of `plumb compare`
std::string_view licences();                                                      ///< of d3 and plot

}  // namespace plumb::reports::page
