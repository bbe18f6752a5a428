#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// The number that the whole text is, without blanks or a plus; empty where it is none, or none that the type holds.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
    Number value{};
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

/// The whole number that the text says, as 1000 or 1e3, 2.5e6; empty for anything else and beyond 2^53 in the second
/// form.
std::optional<std::uint64_t> whole_number(std::string_view text);

/// `count` whole numbers with commas between them, as "64,48" for a size; empty where the text is something else.
std::vector<int> parse_integers(const std::string& text, std::size_t count);

}  // namespace plumb
