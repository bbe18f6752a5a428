#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimators/replicates/integration.h"
#include "reports/run/json.h"
#include "verification/series.h"

namespace plumb::own {

/// The answer of `plumb integrate` for one integral.
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

/// The series of error against n, from sets of independent runs. Without an exact value the error of a run is its
/// spread about the runs' own mean (a variance, which sees no bias), and the name says so.
Series series_of(const std::vector<Runs>& sets, const Answer& answer);

/// The answer for a person: value and error, what they are from, and what they leave out.
std::string text_of(const Answer& answer);
/// The answer as an object of `plumb integrate --json` (docs/json.md).
reports::ListRow row_of(const Answer& answer);

}  // namespace plumb::own
