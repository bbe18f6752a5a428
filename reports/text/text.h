#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/interval.h"

// Numbers as a person reads them, and columns of text.
namespace plumb::reports {

/// The number of columns that UTF-8 text takes (one a code point; we write no wide or combining characters).
std::size_t columns_of(std::string_view text);

/// The text in at most `width` columns, the last of them "…" when something had to go.
std::string shortened(std::string_view text, std::size_t width);

/// The same, where the end says more: "…" goes first.
std::string shortened_from_left(std::string_view text, std::size_t width);

/// The number with three significant digits; "–" for NaN.
std::string readable(double x);
/// The count in short: 1234567 is "1.23M".
std::string readable_count(std::uint64_t count);
/// The interval as "1.2e-05 ± 3.4e-06"; one-sided as "≤ 3e-05"; "–" when it says nothing.
std::string readable(const Interval& interval);

enum class Align { left, right };
/// A column of a table.
struct Column {
    std::string heading;
    Align align = Align::left;
};

/// Rows under headings, each column as wide as its longest cell, the last shortened so that a line fits `width`.
/// `paint` may wrap a padded cell in colour codes; it must not change what is seen.
using Paint = std::string (*)(std::size_t column, const std::string& cell);
std::string table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows,
                  std::size_t width, Paint paint = nullptr);

}  // namespace plumb::reports
