#pragma once

#include "reports/run/results.h"
#include "reports/text/json_values.h"

namespace plumb::reports {

/// The document that to_json() writes, for pages that embed it. For the sources of reports/: it brings the JSON
/// library.
json_values::Json json_document(const Results& results);

/// The same as a page's script reads it: the seed as a string, for JavaScript's numbers end at 2^53, and mutants
/// without the figures that no page draws.
json_values::Json page_document(const Results& results);

}  // namespace plumb::reports
