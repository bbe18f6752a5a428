#include "estimators/points/strata.h"

#include <algorithm>
#include <cmath>

namespace plumb {

double stratum_edge(std::uint64_t i, std::uint64_t n) {
    return static_cast<double>(i) / static_cast<double>(n);
}

double in_stratum(std::uint64_t i, std::uint64_t n, double u) {
    const double x = (static_cast<double>(i) + u) / static_cast<double>(n);
    return std::min(x, std::nextafter(stratum_edge(i + 1, n), 0.0));
}

std::uint64_t stratum_of(double x, std::uint64_t n) {
    // x n may round across an edge, by one stratum at most.
    std::uint64_t i = std::min(static_cast<std::uint64_t>(x * static_cast<double>(n)), n - 1);
    while (x < stratum_edge(i, n)) --i;
    while (x >= stratum_edge(i + 1, n)) ++i;
    return i;
}

Grid grid_of(std::uint64_t n) {
    std::uint64_t rows = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(n)));
    while (rows > 1 && n % rows != 0) --rows;
    return rows > 1 ? Grid{n / rows, rows} : Grid{n, 1};
}

}  // namespace plumb
