#include "core/numbers.h"

namespace plumb {

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
