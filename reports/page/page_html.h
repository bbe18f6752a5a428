#pragma once

#include <string>
#include <string_view>

namespace plumb::reports {

/// The page that draws runs and studies, with the text of a script's data (for_script()) and all that it needs inside.
std::string page_html(std::string_view title, std::string_view data);

}  // namespace plumb::reports
