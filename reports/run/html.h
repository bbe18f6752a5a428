#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "reports/run/results.h"

namespace plumb::reports {

/// The report as one HTML page that needs nothing else: no network, no other file. Sections without content are left
/// out. With `against`, an earlier run, a section lists what changed since.
std::string report_html(const Results& results, const std::optional<Results>& against = {});

/// Writes that page to a file, replaced as a whole or not at all; throws Error naming it when it cannot be written.
void write_report(const Results& results, const std::optional<Results>& against, const std::filesystem::path& file);

/// The page of `plumb converge`: convergence and work–precision only.
void write_converge_report(const RunInfo& run, std::span<const Series> series, const std::filesystem::path& file);

}  // namespace plumb::reports
