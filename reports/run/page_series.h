#pragma once

#include <limits>

#include "reports/run/json_document.h"
#include "reports/run/metric.h"

// The page is given this of series beside the JSON of a run, so that it computes no number itself.
namespace plumb::reports {

/// Adds to the JSON of a series the value of each metric at each of its points, as [value, low, high] under the
/// metric's name ("efficiency/seconds" where the cost counts), and whether its slope meets the expected one. A metric
/// that needs a truth which is not known is left out.
void add_metrics(json_values::Json& json, const Series& series,
                 double truth = std::numeric_limits<double>::quiet_NaN());

/// The axes of figures, and the colours and symbols of their lines.
json_values::Json page_axes();

}  // namespace plumb::reports
