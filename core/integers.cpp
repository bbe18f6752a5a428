#include "core/integers.h"

#include <charconv>

namespace plumb {

std::vector<int> parse_integers(const std::string& text, std::size_t count) {
    std::vector<int> numbers;
    const char *at = text.data(), *const end = at + text.size();
    for (bool comma = true; comma && numbers.size() < count;) {
        const auto [next, failure] = std::from_chars(at, end, numbers.emplace_back());
        if (failure != std::errc()) return {};
        comma = next != end && *next == ',' && numbers.size() < count;
        at = next + (comma ? 1 : 0);
    }
    if (numbers.size() != count || at != end) return {};
    return numbers;
}

}  // namespace plumb
