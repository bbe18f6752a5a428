#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/interval.h"
#include "core/point.h"

namespace plumb::checks {

/// A density given by the probabilities of cells that do not overlap: intervals, or rectangles. It is zero outside of
/// them.
struct CellDensity {
    struct Cell {
        Interval x, y;  ///< y says nothing in one dimension; ends may be infinite
        double probability = 0;
    };
    std::string name;
    int dimension = 1;
    std::vector<Cell> cells;
    /// Where they are known everywhere, not just as masses of cells: the density, and in one dimension its cumulative
    /// function; empty functions where not.
    std::function<double(const Point<2>&)> pdf = {};
    std::function<double(double)> cumulative = {};
    std::string remark = {};  ///< on what `name` became, for a statement; may be empty

    /// The cell's number; cells.size() outside of them all, and for NaN. A cell contains its lower ends, and its upper
    /// ends where no other cell begins: text rounds values below 1 to 1.
    [[nodiscard]] std::size_t cell_of(const Point<2>& point) const;
};

/// The density of a name: uniform, linear:A,B, exponential:RATE, uniform-2d, bilinear:A,B,C,D
/// (estimators/densities/density.h, density_2d.h say what they are); anything else is the name of a CSV file
/// (docs/embedding.md). Throws Error.
CellDensity read_density(const std::string& text);

/// The names that read_density() knows.
std::vector<std::string> density_names();

/// Whether read_density() has a density of this name, or there is a file.
bool is_density_name(const std::string& text);

/// The density of a table's text; `name` names it in messages.
CellDensity parse_density_table(std::string_view text, const std::string& name);

}  // namespace plumb::checks
