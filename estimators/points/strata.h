#pragma once

#include <cstdint>

namespace plumb {

/// Equal strata of [0,1): stratum i of n is [stratum_edge(i, n), stratum_edge(i + 1, n)). Its edges are i/n rounded to
/// double, so that edges, samples and lookup agree to the last bit whatever n.
double stratum_edge(std::uint64_t i, std::uint64_t n);

/// The fraction u in [0,1) of the way through stratum i of n; never rounded into the next stratum, nor to 1.
double in_stratum(std::uint64_t i, std::uint64_t n, double u);

/// The stratum of n in which x in [0,1) lies.
std::uint64_t stratum_of(double x, std::uint64_t n);

/// n cells of a grid: n = columns × rows exactly, the pair of divisors nearest each other, columns ≥ rows.
/// For a prime n that is n × 1: nothing is stratified along y, and we do not hide it by taking another n.
struct Grid {
    std::uint64_t columns = 1, rows = 1;
    friend bool operator==(const Grid&, const Grid&) = default;
};
Grid grid_of(std::uint64_t n);

}  // namespace plumb
