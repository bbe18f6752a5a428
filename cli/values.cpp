#include <charconv>
#include <cmath>

#include "cli/values.h"
#include "core/csv.h"
#include "core/error.h"
#include "core/numbers.h"

namespace plumb::cli {

std::chrono::duration<double> parse_duration(const std::string& text) {
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::string_view unit(end, text.data() + text.size());
    const double scale = unit.empty() || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
    if (failure != std::errc() || scale == 0 || !(value > 0) || !(value * scale < 1e9))
        throw Error(fmt::format("'{}' is not a duration; accepted: 90, 90s, 1.5m, 2h", text));
    return std::chrono::duration<double>(value * scale);
}

std::vector<double> parse_domain(const std::string& text) {
    std::vector<double> ends;
    bool good = true;
    for (const std::string_view field : csv_fields(text)) {
        const std::optional<double> end = csv_number(field);
        good = good && end;
        ends.push_back(end.value_or(0));
    }
    good = good && (ends.size() == 2 || ends.size() == 4);
    for (std::size_t i = 0; good && i < ends.size(); i += 2)
        good = ends[i] < ends[i + 1] && std::isfinite(ends[i + 1] - ends[i]);
    if (!good)
        throw Error(fmt::format("'{}' is not a domain; accepted: x0,x1 or x0,x1,y0,y1 with x0 < x1, y0 < y1", text));
    return ends;
}

std::uint64_t parse_count(const std::string& text, std::uint64_t least, std::uint64_t most) {
    const auto value = whole_number(text);
    if (!value || *value < least || *value > most)
        throw Error(fmt::format("'{}' is not a whole number from {} to {}; accepted: 1000, 1e3", text, least, most));
    return *value;
}

std::vector<int> parse_strategy(const std::string& text) {
    std::vector<int> numbers = parse_integers(text, 2);
    const bool good = !numbers.empty() && numbers[0] >= 0 && numbers[1] >= 1 && numbers[0] + numbers[1] >= 2;
    if (!good)
        throw Error(fmt::format("'{}' is not a strategy; accepted: s,t with s >= 0, t >= 1 and s + t >= 2", text));
    return numbers;
}

std::vector<int> parse_crop(const std::string& text) {
    std::vector<int> numbers = parse_integers(text, 4);
    const bool good = !numbers.empty() && numbers[2] > 0 && numbers[3] > 0;
    if (!good) throw Error(fmt::format("'{}' is not a crop; accepted: x,y,width,height in pixels", text));
    return numbers;
}

int parse_edges(const std::string& text) {
    if (text == "all") return 0;
    const std::vector<int> number = parse_integers(text, 1);
    if (number.empty() || number[0] < 1)
        throw Error(fmt::format("'{}' is no length of paths; accepted: 1, 2, … edges, or all", text));
    return number[0];
}

std::pair<std::string, std::string> parse_definition(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
        throw Error(fmt::format("'{}' is not a definition; accepted: name=value", text));
    return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace plumb::cli
