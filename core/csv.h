#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// What separates the fields of this line: a semicolon, else a comma, else a tab, as it has them outside of quotes;
/// ' ' (runs of blanks) where it has none of these and several words.
char csv_separator(std::string_view line);

/// The fields of one line, without the blanks and the quotes around them; they point into it. What stands in quotes
/// separates nothing.
std::vector<std::string_view> csv_fields(std::string_view line, char separator = ',');

/// The line without a comment, which goes from a # outside of quotes to its end, and without blanks around it.
std::string_view without_comment(std::string_view line);

/// The decimal number that the whole field is, infinities and NaN too; empty where it is none.
std::optional<double> csv_number(std::string_view field);

/// A table of numbers, as read from separated values.
struct NumberTable {
    std::string name;                 ///< of the file, for messages
    std::vector<std::string> header;  ///< names of the columns; empty when there are none
    bool header_is_a_comment = false;
    std::size_t columns = 0;
    std::vector<double> values;      ///< row by row
    std::vector<std::size_t> lines;  ///< of each row, from 1

    [[nodiscard]] std::size_t rows() const { return lines.size(); }
    [[nodiscard]] double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
    [[nodiscard]] std::size_t line(std::size_t row) const { return lines[row]; }
    /// `points.csv:17: column 2`, for an Error about a value; rows and columns from 0, lines and columns in print
    /// from 1.
    [[nodiscard]] std::string where(std::size_t row, std::size_t column) const;
};

/// Which numbers a table may hold; NaN is none of them.
enum class Numbers { finite, extended };

/// Reads RFC 4180 text of numbers, one row a line: separated as csv_separator() finds on the first line that is no
/// comment, with an optional first line of names (or the last comment before the numbers, where it has as many names
/// as these have columns), comments, blanks and quotes around a field; empty lines only before the first row and at
/// the end. Throws Error naming file, line and column for anything else, for rows of unequal length and for a table
/// without a row.
NumberTable parse_csv(std::string_view text, std::string name, Numbers accepted = Numbers::finite);

/// Names of columns in the order in which a reader wants them, e.g. {"x", "f"}.
using ColumnNames = std::vector<std::string>;

/// The table with its columns in the order of that one of `layouts` which names just these, in any order, capitals or
/// not, and with its names. Columns without names, or with names that no layout knows, are taken as they stand; a known
/// name must then stand in its own place. Throws Error for another number of columns and for names that contradict
/// their places.
NumberTable in_order(NumberTable table, const std::vector<ColumnNames>& layouts);

}  // namespace plumb
