#include "core/sample_counts.h"

#include "core/error.h"
#include "core/numbers.h"

namespace plumb {

std::vector<std::uint64_t> parse_sample_counts(const std::string& text) {
    const auto number = [&](std::string_view part) {
        const auto value = whole_number(part).value_or(0);
        if (value == 0 || value > most_samples)
            throw Error(fmt::format(
                "'{}' is not a sample count between 1 and 2^32, in '{}'; accepted: 16..65536, 16,100,1000 or 1e3..1e6", part,
                text));
        return value;
    };
    std::vector<std::uint64_t> counts;
    if (const std::size_t dots = text.find(".."); dots != std::string::npos) {
        const std::uint64_t first = number(std::string_view(text).substr(0, dots)),
                            last = number(std::string_view(text).substr(dots + 2));
        if (last < first)
            throw Error(fmt::format("'{}' runs backwards; accepted: first..last with first ≤ last", text));
        for (std::uint64_t n = first; n <= last; n *= 2) counts.push_back(n);
        return counts;
    }
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        counts.push_back(number(std::string_view(text).substr(begin, comma - begin)));
        begin = comma + 1;
    }
    std::ranges::sort(counts);
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    return counts;
}

}  // namespace plumb
