#pragma once

#include "reports/run/results.h"
#include "reports/text/json_values.h"

namespace plumb::reports {

/// The document that to_json() writes, for pages that embed it. This header is for the sources of reports/, as it
/// brings the JSON library.
json_values::Json json_document(const Results& results);

/// The same document as a page's script reads it: the seed is a string, because JavaScript's numbers end at 2^53, and
/// mutants lack the figures that no page draws.
json_values::Json page_document(const Results& results);

}  // namespace plumb::reports
