#include "core/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/numbers.h"

namespace plumb {
namespace {

// A line that was split at \n alone ends in \r.
constexpr std::string_view blanks = " \t\r";

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view field_of(std::string_view text) {
    text = without_blanks(text);
    const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return quoted ? without_blanks(text.substr(1, text.size() - 2)) : text;
}

// Takes what stands before the mark off the front of the text, and the mark.
std::string_view taken_until(char mark, std::string_view& text) {
    const std::size_t end = std::min(text.find(mark), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return part;
}

bool is_name(std::string_view field) {
    const auto letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; };
    if (field.empty() || !letter(field.front())) return false;
    std::string lower(field);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return !lower.starts_with("nan") && lower != "inf" && lower != "infinity";
}

double finite_number(std::string_view field, const NumberTable& table, std::size_t row, std::size_t column) {
    if (const auto value = csv_number(field); value && std::isfinite(*value)) return *value;
    throw Error(fmt::format("{}: {}; accepted are finite numbers such as 0.25 or 1e-3", table.where(row, column),
                            field.empty() ? "nothing found" : fmt::format("'{:.40}' found", field)));
}

void append_row(std::string_view line, NumberTable& table) {
    const std::size_t row = table.columns == 0 ? 0 : table.rows();
    const std::size_t columns = static_cast<std::size_t>(std::ranges::count(line, ',')) + 1;
    if (table.columns == 0) table.columns = columns;
    if (columns != table.columns)
        throw Error(
            fmt::format("{}:{}: {} columns found; line 1 has {}", table.name, table.line(row), columns, table.columns));
    for (std::size_t column = 0; column < columns; ++column)
        table.values.push_back(finite_number(field_of(taken_until(',', line)), table, row, column));
}

}  // namespace

std::vector<std::string_view> csv_fields(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t commas = std::ranges::count(line, ',') + 1; commas > 0; --commas)
        fields.push_back(field_of(taken_until(',', line)));
    return fields;
}

std::optional<double> csv_number(std::string_view field) {
    if (field.size() > 1 && field[0] == '+' && field[1] != '-') field.remove_prefix(1);
    return number_of<double>(field);
}

std::string NumberTable::where(std::size_t row, std::size_t column) const {
    const std::string heading = header.empty() ? "" : fmt::format(" ({})", header[column]);
    return fmt::format("{}:{}: column {}{}", name, line(row), column + 1, heading);
}

NumberTable parse_csv(std::string_view text, std::string name) {
    NumberTable table;
    table.name = std::move(name);
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
    while (!text.empty() && std::string_view(" \t\r\n").find(text.back()) != std::string_view::npos)
        text.remove_suffix(1);
    for (bool first = true; !text.empty(); first = false) {
        std::string_view line = taken_until('\n', text);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (const auto fields = first ? csv_fields(line) : std::vector<std::string_view>{};
            first && std::ranges::all_of(fields, is_name)) {
            table.header.assign(fields.begin(), fields.end());
            table.columns = fields.size();
        } else {
            append_row(line, table);
        }
    }
    if (table.rows() == 0)
        throw Error(fmt::format("{}: no row of numbers found; accepted are lines such as 0.25,0.5", table.name));
    return table;
}

}  // namespace plumb
