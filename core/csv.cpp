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

// Where the mark first stands outside of quotes; the end where it does not.
std::size_t find_mark(std::string_view text, char mark) {
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!quoted && (text[i] == mark || (mark == ' ' && text[i] == '\t'))) return i;
        if (text[i] == '"') quoted = !quoted;
    }
    return text.size();
}

template <class Use>
void for_fields(std::string_view line, char separator, const Use& use) {
    for (bool last = false; !last;) {
        if (separator == ' ') line = without_blanks(line);
        const std::size_t end = find_mark(line, separator);
        last = end == line.size();
        use(field_of(line.substr(0, end)));
        line.remove_prefix(std::min(end + 1, line.size()));
    }
}

bool is_name(std::string_view field) {
    const auto letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; };
    return !field.empty() && letter(field.front()) && !csv_number(field);
}

std::vector<std::string> names_in(std::string_view line, char separator) {
    const std::vector<std::string_view> fields = csv_fields(line, separator);
    if (!std::ranges::all_of(fields, is_name)) return {};
    return {fields.begin(), fields.end()};
}

class Reader {
public:
    Reader(std::string name, Numbers accepted) : accepted_(accepted) { table_.name = std::move(name); }

    void read(std::string_view line, std::size_t number) {
        const std::string_view text = without_comment(line);
        const std::size_t comment = line.find_first_not_of(blanks);
        if (text.empty() && comment != std::string_view::npos) {
            if (table_.rows() == 0) comment_ = line.substr(line.find('#') + 1);
            return;
        }
        if (table_.columns == 0) {
            if (text.empty()) return;
            separator_ = csv_separator(text);
            first_ = number;
            table_.header = names_in(text, separator_);
            table_.columns = table_.header.size();
            if (table_.columns > 0) return;
        }
        append(text, number);
    }

    NumberTable result() && {
        if (table_.rows() == 0)
            throw Error(fmt::format("{}: no row of numbers found; accepted are lines such as 0.25,0.5", table_.name));
        std::vector<std::string> names = names_in(comment_, csv_separator(comment_));
        if (table_.header.empty() && names.size() == table_.columns) {
            table_.header = std::move(names);
            table_.header_is_a_comment = true;
        }
        return std::move(table_);
    }

private:
    void append(std::string_view text, std::size_t line) {
        table_.lines.push_back(line);
        const std::size_t before = table_.values.size();
        for_fields(text, separator_, [&](std::string_view field) {
            table_.values.push_back(number(field, table_.values.size() - before));
        });
        const std::size_t columns = table_.values.size() - before;
        if (table_.columns == 0) table_.columns = columns;
        if (columns != table_.columns)
            throw Error(fmt::format("{}:{}: {} columns found; line {} has {}", table_.name, line, columns, first_,
                                    table_.columns));
    }

    double number(std::string_view field, std::size_t column) const {
        const auto value = csv_number(field);
        if (value && (std::isfinite(*value) || (accepted_ == Numbers::extended && std::isinf(*value)))) return *value;
        const bool comma = field.find(',') != std::string_view::npos;
        throw Error(fmt::format("{}: {}; accepted are {}numbers such as 0.25 or 1e-3{}",
                                table_.where(table_.rows() - 1, column),
                                field.empty() ? "nothing found" : fmt::format("'{:.40}' found", field),
                                accepted_ == Numbers::finite ? "finite " : "", comma ? ", with a decimal point" : ""));
    }

    Numbers accepted_;
    NumberTable table_;
    char separator_ = ',';
    std::size_t first_ = 0;  // line that the others are held against
    std::string_view comment_;
};

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string text_of(const std::vector<ColumnNames>& layouts) {
    std::string all;
    for (const ColumnNames& names : layouts)
        all += fmt::format("{}{} ({})", all.empty() ? "" : " and ", names.size(), fmt::join(names, ","));
    return all;
}

// The place of each of the layout's columns in the table; empty where the names are not just these.
std::vector<std::size_t> places(const std::vector<std::string>& found, const ColumnNames& layout) {
    std::vector<std::size_t> places;
    for (const std::string& name : layout)
        if (const auto at = std::ranges::find(found, name); at != found.end())
            places.push_back(static_cast<std::size_t>(at - found.begin()));
    if (places.size() != layout.size() || found.size() != layout.size()) places.clear();
    return places;
}

NumberTable permuted(NumberTable table, const std::vector<std::size_t>& places, const ColumnNames& names) {
    std::vector<double> row(table.columns);
    table.header = names;
    for (std::size_t begin = 0; begin < table.values.size(); begin += table.columns) {
        for (std::size_t i = 0; i < places.size(); ++i) row[i] = table.values[begin + places[i]];
        std::ranges::copy(row, table.values.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    return table;
}

}  // namespace

char csv_separator(std::string_view line) {
    for (const char mark : {';', ',', '\t'})
        if (find_mark(line, mark) < line.size()) return mark;
    return find_mark(without_blanks(line), ' ') < without_blanks(line).size() ? ' ' : ',';
}

std::vector<std::string_view> csv_fields(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    for_fields(line, separator, [&](std::string_view field) { fields.push_back(field); });
    return fields;
}

std::string_view without_comment(std::string_view line) {
    return without_blanks(line.substr(0, find_mark(line, '#')));
}

std::optional<double> csv_number(std::string_view field) {
    if (field.size() > 1 && field[0] == '+' && field[1] != '-') field.remove_prefix(1);
    return number_of<double>(field);
}

std::string NumberTable::where(std::size_t row, std::size_t column) const {
    const std::string heading = column < header.size() ? fmt::format(" ({})", header[column]) : "";
    return fmt::format("{}:{}: column {}{}", name, line(row), column + 1, heading);
}

NumberTable parse_csv(std::string_view text, std::string name, Numbers accepted) {
    Reader reader(std::move(name), accepted);
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
    while (!text.empty() && std::string_view(" \t\r\n").find(text.back()) != std::string_view::npos)
        text.remove_suffix(1);
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        reader.read(text.substr(0, end), number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return std::move(reader).result();
}

NumberTable in_order(NumberTable table, const std::vector<ColumnNames>& layouts) {
    std::vector<std::string> found;
    for (const std::string& name : table.header) found.push_back(lower(name));
    for (const ColumnNames& layout : layouts)
        if (const auto order = places(found, layout); !order.empty()) return permuted(std::move(table), order, layout);
    if (table.header_is_a_comment) {  // words that say something else
        found.clear();
        table.header.clear();
    }
    const auto layout = std::ranges::find(layouts, table.columns, &ColumnNames::size);
    if (layout == layouts.end())
        throw Error(fmt::format("{}: {} columns found{}; accepted are {}", table.name, table.columns,
                                found.empty() ? "" : fmt::format(" ({})", fmt::join(found, ",")), text_of(layouts)));
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const ColumnNames& names : layouts)
            if (std::ranges::count(names, found[i]) > 0 && found[i] != (*layout)[i])
                throw Error(fmt::format("{}: columns {} found; accepted are {}, in any order", table.name,
                                        fmt::join(found, ","), text_of(layouts)));
    return table;
}

}  // namespace plumb
