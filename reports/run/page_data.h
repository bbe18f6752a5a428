#pragma once

#include <optional>
#include <string>

#include "reports/run/results.h"

namespace plumb::reports {

/// The data that the page's script reads: {"results": as to_json(), "against": null or {run, differences}}, on one line
/// and fit to stand inside a <script> element. The seed is a string: JavaScript's numbers end at 2^53.
std::string page_data(const Results& results, const std::optional<Results>& against);

}  // namespace plumb::reports
