#pragma once

#include <span>
#include <string>

#include "reports/run/differences.h"
#include "reports/run/json.h"
#include "reports/run/results.h"
#include "reports/run/store.h"

// Tables fit a terminal of `width` columns; a row is never broken, and what is too long ends in "…". Colour repeats
// what words say already, and is for terminals only.
namespace plumb::reports {

/// The appearance of a table: whether in colour, and how wide in columns.
struct TableStyle {
    static constexpr int unlimited = 1 << 20;  ///< of a pipe or a file: nothing is shortened
    bool colour = false;
    int width = 120;
};

/// The verdicts one a line (a terminal leaves out kind and seconds, and shortens ids from the left: reasons say more),
/// the mutants that live, and the summary as the last line.
std::string verdict_table(const Results& results, const TableStyle& style = {});

/// A table a series: n, evaluations, seconds, MSE with its interval and bias; then the slope, fitted and expected.
std::string converge_table(std::span<const Series> series, const TableStyle& style = {});

std::string differences_table(const Differences& differences, const TableStyle& style = {});

/// The runs of a store: number, when, size, seed, outcomes.
std::string runs_table(std::span<const StoredRun> runs, const TableStyle& style = {});

/// A list as `plumb list` prints it: the fields of the first row are the headings, later columns of more than 40
/// characters are shortened, unless the width is unlimited.
std::string list_table(std::span<const ListRow> rows, const TableStyle& style = {});

}  // namespace plumb::reports
