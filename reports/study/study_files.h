#pragma once

#include <vector>

#include "reports/study/folder.h"
#include "reports/study/study_result.h"

namespace plumb::reports {

/// The files that a study leaves behind: index.html (needs nothing else), series.csv (a row for each point of each
/// series), one SVG for each integrand and metric of each figure, and headlines.csv and headlines.json where there are
/// some.
std::vector<FolderFile> study_files(const StudyResult& study);

/// The series as CSV with the columns figure, estimator, integrand, n, evaluations, seconds, mse, mse_low, mse_high,
/// bias, bias_standard_error, replicates, integral. RFC 4180, numbers in full, an unknown number as an empty cell.
std::string study_csv(const StudyResult& study);

}  // namespace plumb::reports
