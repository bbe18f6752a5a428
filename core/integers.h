#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace plumb {

/// `count` whole numbers with commas between them, as "64,48" for a size; empty where the text is something else.
std::vector<int> parse_integers(const std::string& text, std::size_t count);

}  // namespace plumb
