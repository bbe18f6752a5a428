#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace plumb::reports {

/// A cell of RFC 4180.
inline std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

/// The number in full; empty for NaN.
inline std::string csv_cell(double x) {
    return std::isnan(x) ? "" : fmt::format("{}", x);
}

}  // namespace plumb::reports
