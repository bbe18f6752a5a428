#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/run/results.h"

// The JSON that Plumb writes is documented in docs/json.md. Numbers that JSON lacks: null is NaN (unknown), the strings
// "inf" and "-inf" are the infinities. Keys come in a fixed order; new ones may be added, none is renamed or removed.
namespace plumb::reports {

/// The whole of a run as one document, indented by two blanks.
std::string to_json(const Results& results);
/// The run that a document of to_json() tells of; throws Error naming `name` (the file, say) for anything that is not
/// such a document.
Results results_from_json(std::string_view text, std::string_view name);

/// The JSON that `plumb converge --json` writes: run, series, and sentences on the truths that are no exact values.
std::string converge_json(const RunInfo& run, std::span<const Series> series, std::span<const std::string> truths);

/// The JSON that `plumb integrate --json` writes: run, answers (one object each) and series.
std::string integration_json(const RunInfo& run, std::span<const std::vector<Field>> answers,
                             std::span<const Series> series);

/// A row of a list: its named values in the order in which they are written.
using ListRow = std::vector<Field>;
/// The JSON that `plumb list … --json` writes: an array with one object a row.
std::string list_json(std::span<const ListRow> rows);

/// One claim, mutant or series as it stands in that document, on one line: the store's columns.
std::string claim_json(const ClaimResult& claim);
std::string mutant_json(const MutantResult& mutant);
std::string series_json(const Series& series);
ClaimResult claim_from_json(std::string_view text, std::string_view name);
MutantResult mutant_from_json(std::string_view text, std::string_view name);
Series series_from_json(std::string_view text, std::string_view name);

}  // namespace plumb::reports
