#include "core/numbers.h"

#include <cmath>

namespace plumb {

std::optional<std::uint64_t> whole_number(std::string_view text) {
    if (const auto digits = number_of<std::uint64_t>(text)) return digits;
    const auto number = number_of<double>(text);
    if (!number || !(*number >= 0 && *number <= 0x1p53) || *number != std::floor(*number)) return {};
    return static_cast<std::uint64_t>(*number);
}

std::vector<int> parse_integers(const std::string& text, std::size_t count) {
    std::vector<int> numbers;
    for (std::string_view rest = text; numbers.size() <= count;) {
        const std::size_t comma = rest.find(',');
        const std::optional<int> number = number_of<int>(rest.substr(0, comma));
        if (!number) return {};
        numbers.push_back(*number);
        if (comma == std::string_view::npos) break;
        rest.remove_prefix(comma + 1);
    }
    return numbers.size() == count ? numbers : std::vector<int>();
}

}  // namespace plumb
