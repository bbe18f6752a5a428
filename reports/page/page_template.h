#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumb::reports {

/// The document with each {{name}} replaced by its text; the parts come in the order of the document, and what is put
/// in is never searched. Throws std::logic_error when the document lacks one.
std::string filled(std::string_view document, const std::vector<std::pair<std::string, std::string_view>>& parts);

}  // namespace plumb::reports
