#pragma once

#include <string>
#include <string_view>

namespace plumb::reports {

/// The text as content or as a quoted attribute of XML, SVG and HTML; what XML cannot hold, bytes that are not UTF-8
/// and most control characters, becomes U+FFFD.
std::string escaped(std::string_view text);

}  // namespace plumb::reports
