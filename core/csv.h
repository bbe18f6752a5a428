#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// The fields of one line of comma-separated values, without the blanks and the quotes around them; they point into it.
std::vector<std::string_view> csv_fields(std::string_view line);

/// The decimal number that the whole field is, infinities and NaN too; empty where it is none.
std::optional<double> csv_number(std::string_view field);

/// A table of finite numbers, as read from comma-separated values.
struct NumberTable {
    std::string name;                 ///< of the file, for messages
    std::vector<std::string> header;  ///< names of the columns; empty when the first line held numbers
    std::size_t columns = 0;
    std::vector<double> values;  ///< row by row

    [[nodiscard]] std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
    [[nodiscard]] double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
    [[nodiscard]] std::size_t line(std::size_t row) const { return row + (header.empty() ? 1 : 2); }
    /// `points.csv:17: column 2`, for an Error about a value; rows and columns from 0, lines and columns in print
    /// from 1.
    [[nodiscard]] std::string where(std::size_t row, std::size_t column) const;
};

/// Reads RFC 4180 text of numbers, one row a line: an optional first line of names, blanks around a field and quotes
/// around it are allowed, empty lines only at the end. Throws Error naming file, line and column for anything that is
/// not a finite decimal number, for rows of unequal length and for a table without a row.
NumberTable parse_csv(std::string_view text, std::string name);

}  // namespace plumb
