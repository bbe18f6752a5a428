#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimators/replicates/integration.h"
#include "reports/run/results.h"

namespace plumb::cli {

/// One integral as `plumb integrate` tells it.
struct Answer {
    std::string integrand, method;
    Estimate estimate = {};             ///< evaluations: those of the answer alone
    std::uint64_t n = 0, runs = 1;      ///< samples a run, independent runs
    std::uint64_t all_evaluations = 0;  ///< with those that chose n and drew the plot
    std::optional<double> exact = {}, target = {};
    bool target_met = true;
    std::vector<std::string> known = {};  ///< sentences: what the error contains and what not
    std::optional<Series> series = {};
};

/// Error against n for sets of independent runs. Without an exact value the error of a run is its spread about the
/// runs' own mean (a variance, which sees no bias), and the name says so.
Series series_of(const std::vector<Runs>& sets, const Answer& answer);

/// Prints the answers, writes the page and the JSON (an empty name: none); the program's exit code: 3 when a target was
/// missed.
int tell(const std::vector<Answer>& answers, const reports::RunInfo& run, const std::string& json,
         const std::string& report);

}  // namespace plumb::cli
