#include "checks/sampler/cell_density.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

#include "core/csv.h"
#include "core/error.h"
#include "core/file.h"
#include "estimators/densities/density.h"
#include "estimators/densities/density_2d.h"

namespace plumb::checks {
namespace {

constexpr std::size_t cells_1d = 64, cells_2d = 8;  // 8 by 8
constexpr std::size_t most_cells = 4096;

using Parameters = std::vector<double>;

std::optional<double> number(std::string_view field) {
    const std::optional<double> value = csv_number(field);
    return value && !std::isnan(*value) ? value : std::nullopt;
}

// Cells of equal probability: their ends are the density's own quantiles.
template <class Density>
CellDensity by_quantiles(const Density& density) {
    CellDensity result;
    const auto end = [&](std::size_t i) { return density.sample(static_cast<double>(i) / cells_1d); };
    for (std::size_t i = 0; i < cells_1d; ++i)
        result.cells.push_back({{end(i), end(i + 1)}, {}, density.invert(end(i + 1)) - density.invert(end(i))});
    return result;
}

// The mean of a bilinear density over a rectangle is its value in the middle.
CellDensity bilinear(const BilinearDensity& density) {
    CellDensity result{.name = {}, .dimension = 2, .cells = {}};
    constexpr double side = 1.0 / cells_2d;
    for (std::size_t i = 0; i < cells_2d; ++i)
        for (std::size_t j = 0; j < cells_2d; ++j) {
            const double x = static_cast<double>(i) * side, y = static_cast<double>(j) * side;
            result.cells.push_back(
                {{x, x + side}, {y, y + side}, density.pdf({x + side / 2, y + side / 2}) * side * side});
        }
    return result;
}

struct Named {
    std::string_view name, parameters;
    std::size_t count;
    CellDensity (*make)(const Parameters&);
};

const std::array named_densities{
    Named{"uniform", "", 0, [](const Parameters&) { return by_quantiles(UniformDensity()); }},
    Named{"linear", "A,B", 2, [](const Parameters& p) { return by_quantiles(LinearDensity(p[0], p[1])); }},
    Named{"exponential", "RATE", 1, [](const Parameters& p) { return by_quantiles(TruncatedExponential(p[0])); }},
    Named{"uniform-2d", "", 0, [](const Parameters&) { return bilinear(BilinearDensity(1, 1, 1, 1)); }},
    Named{"bilinear", "A,B,C,D", 4,
          [](const Parameters& p) { return bilinear(BilinearDensity(p[0], p[1], p[2], p[3])); }},
};

CellDensity make_named(const Named& named, std::string_view text) {
    Parameters parameters;
    if (const std::size_t colon = text.find(':'); colon != std::string_view::npos)
        for (const std::string_view part : csv_fields(text.substr(colon + 1)))
            if (const auto value = number(part)) parameters.push_back(*value);
    const std::string form =
        named.count == 0 ? std::string(named.name) : fmt::format("{}:{}", named.name, named.parameters);
    const auto commas = static_cast<std::size_t>(std::ranges::count(text, ','));
    if (parameters.size() != named.count || (named.count > 0 && commas + 1 != named.count) ||
        (named.count == 0 && text != named.name))
        throw Error(fmt::format("the density '{}' is not of the form {}", text, form));
    return named.make(parameters);
}

// The table's rows, in the columns that its first line names.
class Table {
public:
    Table(std::string_view text, const std::string& name) : name_(name) {
        std::istringstream rows{std::string(text)};
        std::size_t line = 1;
        for (std::string row; std::getline(rows, row); ++line) {
            const std::vector<std::string_view> fields = csv_fields(row);
            if ((fields.size() == 1 && fields[0].empty()) || fields[0].starts_with('#')) continue;
            if (columns_.empty())
                read_heading(fields, line);
            else
                read_row(fields, line);
        }
        if (columns_.empty()) throw Error(fmt::format("{}: no heading; accepted: {}", name, headings));
    }

    CellDensity density;

private:
    static constexpr std::string_view headings =
        "from,to,density or from,to,probability; x_from,x_to,y_from,y_to,… in two dimensions";

    void read_heading(const std::vector<std::string_view>& fields, std::size_t line) {
        columns_.assign(fields.begin(), fields.end());
        const std::vector<std::string> ends(columns_.begin(), columns_.end() - 1);
        density.dimension = ends.size() == 4 ? 2 : 1;
        is_density_ = columns_.back() == "density";
        const bool known = ends == std::vector<std::string>{"from", "to"} ||
                           ends == std::vector<std::string>{"x_from", "x_to", "y_from", "y_to"};
        if (!known || (!is_density_ && columns_.back() != "probability"))
            throw Error(fmt::format("{}, line {}: the heading is '{}'; accepted: {}", name_, line,
                                    fmt::join(fields, ","), headings));
    }

    void read_row(const std::vector<std::string_view>& parts, std::size_t line) {
        if (parts.size() != columns_.size())
            throw Error(
                fmt::format("{}, line {}: {} values for {} columns", name_, line, parts.size(), columns_.size()));
        std::vector<double> values;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto value = number(parts[i]);
            if (!value)
                throw Error(
                    fmt::format("{}, line {}, column {}: '{}' is not a number", name_, line, columns_[i], parts[i]));
            values.push_back(*value);
        }
        CellDensity::Cell cell{.x = {values[0], values[1]}, .y = {}, .probability = values.back()};
        if (density.dimension == 2) cell.y = {values[2], values[3]};
        for (std::size_t i = 0; i + 1 < values.size(); i += 2)
            if (!(values[i] < values[i + 1]))
                throw Error(fmt::format("{}, line {}: the cell ends at {} before it begins at {}", name_, line,
                                        values[i + 1], values[i]));
        if (is_density_) cell.probability *= cell.x.width() * (density.dimension == 2 ? cell.y.width() : 1);
        if (!(values.back() >= 0 && std::isfinite(cell.probability)))
            throw Error(fmt::format("{}, line {}, column {}: {} gives the cell no finite probability >= 0", name_, line,
                                    columns_.back(), values.back()));
        for (std::size_t i = 0; i < density.cells.size(); ++i)
            if (overlap(cell.x, density.cells[i].x) && overlap(cell.y, density.cells[i].y))
                throw Error(fmt::format("{}, line {}: the cell overlaps cell {}", name_, line, i));
        if (density.cells.size() == most_cells)
            throw Error(fmt::format("{}, line {}: more than {} cells", name_, line, most_cells));
        density.cells.push_back(cell);
    }

    static bool overlap(const Interval& a, const Interval& b) { return a.low < b.high && b.low < a.high; }

    std::string name_;
    std::vector<std::string> columns_;
    bool is_density_ = false;
};

}  // namespace

std::size_t CellDensity::cell_of(const Point<2>& point) const {
    const auto within = [&](const Interval& interval, double at) { return interval.low <= at && at < interval.high; };
    const auto half_open = [&](const Cell& cell) {
        return within(cell.x, point[0]) && (dimension == 1 || within(cell.y, point[1]));
    };
    const auto closed = [&](const Cell& cell) {
        return cell.x.contains(point[0]) && (dimension == 1 || cell.y.contains(point[1]));
    };
    auto found = std::ranges::find_if(cells, half_open);
    if (found == cells.end()) found = std::ranges::find_if(cells, closed);
    return static_cast<std::size_t>(found - cells.begin());
}

CellDensity parse_density_table(std::string_view text, const std::string& name) {
    CellDensity density = Table(text, name).density;
    density.name = name;
    double total = 0;
    for (const CellDensity::Cell& cell : density.cells) total += cell.probability;
    if (std::ranges::count_if(density.cells, [](const CellDensity::Cell& cell) { return cell.probability > 0; }) < 2)
        throw Error(fmt::format("{}: fewer than two cells have probability", name));
    if (!(std::abs(total - 1) <= 1e-6))
        throw Error(fmt::format("{}: the cells' probabilities sum to {:.9g}; accepted: 1 within 1e-6", name, total));
    for (CellDensity::Cell& cell : density.cells) cell.probability /= total;
    return density;
}

CellDensity read_density(const std::string& text) {
    std::vector<std::string> known;
    for (const Named& named : named_densities) {
        known.emplace_back(named.name);
        if (std::string_view(text).substr(0, text.find(':')) != named.name) continue;
        CellDensity density = make_named(named, text);
        density.name = text;
        return density;
    }
    if (!std::filesystem::exists(text))
        throw Error(
            fmt::format("the density '{}' is no file and has no known name; known: {}", text, fmt::join(known, ", ")));
    return parse_density_table(read_file(text), text);
}

}  // namespace plumb::checks
