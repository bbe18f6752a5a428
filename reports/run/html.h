#pragma once

#include <optional>
#include <span>
#include <string>

#include "reports/run/results.h"

namespace plumb::reports {

/// The report as one HTML page that needs nothing else: no network, no other file. Sections without content are left
/// out. With `against`, an earlier run, a section lists what changed since.
std::string report_html(const Results& results, const std::optional<Results>& against = {});

/// The page of `plumb converge`: convergence and work–precision only.
std::string converge_report_html(const RunInfo& run, std::span<const Series> series);

}  // namespace plumb::reports
