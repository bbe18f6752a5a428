#include "checks/sampler/cell_density.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

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

double area(const CellDensity::Cell& cell, int dimension) {
    return cell.x.width() * (dimension == 2 ? cell.y.width() : 1);
}

std::vector<std::string> lower_case(std::vector<std::string> names) {
    for (std::string& name : names)
        for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return names;
}

// Cells of equal probability: their ends are the density's own quantiles.
template <class Density>
CellDensity by_quantiles(const Density& density) {
    CellDensity result;
    const auto end = [&](std::size_t i) { return density.sample(static_cast<double>(i) / cells_1d); };
    for (std::size_t i = 0; i < cells_1d; ++i)
        result.cells.push_back({{end(i), end(i + 1)}, {}, density.invert(end(i + 1)) - density.invert(end(i))});
    result.cumulative = [density](double x) { return density.invert(x); };
    result.pdf = [density](const Point<2>& p) { return density.pdf(p[0]); };
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
    result.pdf = [density](const Point<2>& p) { return density.pdf(p); };
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

constexpr std::string_view headings =
    "from,to,density or from,to,probability; x_from,x_to,y_from,y_to,… in two dimensions";

// The table with the columns in this order. Throws Error unless a line names them.
NumberTable table_of_cells(std::string_view text, const std::string& name) {
    std::vector<ColumnNames> layouts;
    for (const ColumnNames& ends : {ColumnNames{"from", "to"}, ColumnNames{"x_from", "x_to", "y_from", "y_to"}})
        for (const char* mass : {"density", "probability"}) {
            layouts.push_back(ends);
            layouts.back().emplace_back(mass);
        }
    NumberTable table = parse_csv(text, name, Numbers::extended);
    const std::string found = table.header.empty() ? "no heading" : fmt::format("{}", fmt::join(table.header, ","));
    const auto unknown = [&] {
        return Error(fmt::format("{}: the heading is '{}'; accepted: {}", name, found, headings));
    };
    if (table.header.empty() || std::ranges::none_of(layouts, [&](const ColumnNames& names) {
            return std::ranges::is_permutation(names, lower_case(table.header));
        }))
        throw unknown();
    return in_order(std::move(table), layouts);
}

bool overlap(const Interval& a, const Interval& b) {
    return a.low < b.high && b.low < a.high;
}

void append_cell(const NumberTable& table, std::size_t row, CellDensity& density) {
    const std::size_t mass = table.columns - 1;
    const auto at = [&](std::size_t column) { return table.at(row, column); };
    const std::string line = fmt::format("{}:{}", table.name, table.line(row));
    CellDensity::Cell cell{.x = {at(0), at(1)}, .y = {}, .probability = at(mass)};
    if (density.dimension == 2) cell.y = {at(2), at(3)};
    for (std::size_t i = 0; i < mass; i += 2)
        if (!(at(i) < at(i + 1)))
            throw Error(fmt::format("{}: the cell ends at {} before it begins at {}", line, at(i + 1), at(i)));
    if (table.header[mass] == "density") cell.probability *= area(cell, density.dimension);
    if (!(at(mass) >= 0 && std::isfinite(cell.probability)))
        throw Error(fmt::format("{}: {} gives the cell no finite probability >= 0", table.where(row, mass), at(mass)));
    for (std::size_t i = 0; i < density.cells.size(); ++i)
        if (overlap(cell.x, density.cells[i].x) && overlap(cell.y, density.cells[i].y))
            throw Error(fmt::format("{}: the cell overlaps cell {}", line, i));
    if (density.cells.size() == most_cells) throw Error(fmt::format("{}: more than {} cells", line, most_cells));
    density.cells.push_back(cell);
}

// Of a table of constant densities, which is known everywhere.
void know_everywhere(CellDensity& density) {
    const auto cells = std::make_shared<const CellDensity>(density);
    density.pdf = [cells](const Point<2>& p) {
        const std::size_t cell = cells->cell_of(p);
        return cell == cells->cells.size()
                   ? 0
                   : cells->cells[cell].probability / area(cells->cells[cell], cells->dimension);
    };
    if (density.dimension == 2) return;
    density.cumulative = [cells](double x) {
        double sum = 0;
        for (const CellDensity::Cell& cell : cells->cells)
            sum += cell.probability * std::clamp((x - cell.x.low) / cell.x.width(), 0.0, 1.0);
        return sum;
    };
}

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
    const NumberTable table = table_of_cells(text, name);
    CellDensity density{.name = name, .dimension = table.columns == 5 ? 2 : 1, .cells = {}};
    for (std::size_t row = 0; row < table.rows(); ++row) append_cell(table, row, density);
    double total = 0;
    for (const CellDensity::Cell& cell : density.cells) total += cell.probability;
    if (std::ranges::count_if(density.cells, [](const CellDensity::Cell& cell) { return cell.probability > 0; }) < 2)
        throw Error(fmt::format("{}: fewer than two cells have probability", name));
    if (!(std::abs(total - 1) <= 1e-6))
        throw Error(fmt::format("{}: the cells' probabilities sum to {:.9g}; accepted: 1 within 1e-6", name, total));
    for (CellDensity::Cell& cell : density.cells) cell.probability /= total;
    if (table.header.back() == "density") know_everywhere(density);
    return density;
}

std::vector<std::string> density_names() {
    std::vector<std::string> names;
    for (const Named& named : named_densities) names.emplace_back(named.name);
    return names;
}

bool is_density_name(const std::string& text) {
    const auto named = [&](const Named& one) { return std::string_view(text).substr(0, text.find(':')) == one.name; };
    std::error_code ignored;  // a formula may be too long for a name
    return std::ranges::any_of(named_densities, named) || std::filesystem::exists(text, ignored);
}

CellDensity read_density(const std::string& text) {
    for (const Named& named : named_densities) {
        if (std::string_view(text).substr(0, text.find(':')) != named.name) continue;
        CellDensity density = make_named(named, text);
        density.name = text;
        return density;
    }
    if (std::error_code ignored; !std::filesystem::exists(text, ignored))
        throw Error(fmt::format("the density '{}' is no file and has no known name; known: {}", text,
                                fmt::join(density_names(), ", ")));
    return parse_density_table(read_file(text), text);
}

}  // namespace plumb::checks
