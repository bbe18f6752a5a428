#include "scenes/description/properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace plumb::description {

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string keyword(Properties& properties, const std::string& name, const std::string& otherwise) {
    return lower_case(properties.string(name, otherwise));
}

double parse_number(const std::string& text, const Place& place) {
    const auto first = text.find_first_not_of(" \t\n\r+"), last = text.find_last_not_of(" \t\n\r");
    double value = 0;
    if (first != std::string::npos) {
        const char* const end = text.data() + last + 1;
        const auto [stop, code] = std::from_chars(text.data() + first, end, value);
        if (code == std::errc{} && stop == end && std::isfinite(value)) return value;
    }
    throw place.error(fmt::format("'{}' where a finite number is expected", text));
}

}  // namespace plumb::description
