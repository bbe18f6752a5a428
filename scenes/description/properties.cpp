#include "scenes/description/properties.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace plumb::description {

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
