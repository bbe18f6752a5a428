#include "reports/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb::reports {
namespace {

bool starts_code_point(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

std::string padded(const std::string& cell, std::size_t width, Align align) {
    const std::string blanks(width - std::min(width, columns_of(cell)), ' ');
    return align == Align::left ? cell + blanks : blanks + cell;
}

}  // namespace

std::size_t columns_of(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, starts_code_point));
}

std::string shortened(std::string_view text, std::size_t width) {
    if (columns_of(text) <= width) return std::string(text);
    if (width == 0) return "";
    std::size_t bytes = 0;
    for (std::size_t seen = 0; bytes < text.size(); ++bytes)
        if (starts_code_point(text[bytes]) && ++seen == width) break;
    return std::string(text.substr(0, bytes)) + "…";
}

std::string shortened_from_left(std::string_view text, std::size_t width) {
    const std::size_t columns = columns_of(text);
    if (columns <= width) return std::string(text);
    if (width == 0) return "";
    std::size_t bytes = 0;
    for (std::size_t seen = 0; bytes < text.size(); ++bytes)
        if (starts_code_point(text[bytes]) && seen++ == columns - width + 1) break;
    return "…" + std::string(text.substr(bytes));
}

std::string readable(double x) {
    return std::isnan(x) ? "–" : fmt::format("{:.3g}", x);
}

std::string readable_count(std::uint64_t count) {
    if (count < 10'000) return std::to_string(count);
    double scaled = static_cast<double>(count);
    for (const char* unit : {"k", "M", "G", "T"})
        if ((scaled /= 1000) < 999.5) return fmt::format("{:.3g}{}", scaled, unit);
    return fmt::format("{:.3g}", static_cast<double>(count));
}

std::string readable(const Interval& i) {
    if (i.low == 0 && i.high > 0) return fmt::format("≤ {:.2g}", i.high);  // of something that has no sign
    if (i.bounded()) {
        const double half = i.width() / 2, middle = i.low + half;
        return half == 0 ? fmt::format("{:.2g}", middle) : fmt::format("{:.1e} ± {:.1e}", middle, half);
    }
    if (std::isfinite(i.high)) return fmt::format("≤ {:.2g}", i.high);
    if (std::isfinite(i.low)) return fmt::format("≥ {:.2g}", i.low);
    return "–";
}

std::string table(const std::vector<Column>& columns, const std::vector<std::vector<std::string>>& rows,
                  std::size_t width, Paint paint) {
    std::vector<std::size_t> widths;
    std::size_t before_last = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        std::size_t widest = columns_of(columns[c].heading);
        for (const auto& row : rows) widest = std::max(widest, columns_of(row[c]));
        widths.push_back(widest);
        if (c + 1 < columns.size()) before_last += widest + 2;
    }
    const std::size_t room = width > before_last ? width - before_last : 0;
    widths.back() = std::min(widths.back(), std::max<std::size_t>(room, 12));

    std::string text;
    const auto line = [&](const auto& cell_of) {
        std::string line;
        for (std::size_t c = 0; c < columns.size(); ++c) line += (c ? "  " : "") + cell_of(c);
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    };
    const auto fitted = [&](const std::string& cell, std::size_t c) {
        return padded(shortened(cell, widths[c]), widths[c], columns[c].align);
    };
    line([&](std::size_t c) { return fitted(columns[c].heading, c); });
    for (const auto& row : rows)
        line([&](std::size_t c) {
            const std::string cell = fitted(row[c], c);
            return paint ? paint(c, cell) : cell;
        });
    return text;
}

}  // namespace plumb::reports
