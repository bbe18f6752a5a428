#pragma once

#include <string>

#include "reports/run/table.h"
#include "reports/study/study_result.h"

namespace plumb::reports {

/// The study as text, a line for each series of each figure: the error at the largest n, and the slope of log MSE on
/// log n, fitted and expected.
std::string study_table(const StudyResult& study, const TableStyle& style = {});

}  // namespace plumb::reports
