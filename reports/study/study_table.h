#pragma once

#include <string>

#include "reports/study/study_result.h"
#include "reports/run/table.h"

namespace plumb {

/// A line for each series of each figure: the error at the largest n, and the slope of log MSE on log n, fitted and
/// expected.
std::string study_table(const StudyResult& study, const TableStyle& style = {});

}  // namespace plumb
