#pragma once

#include <string>

#include "reports/study/study_result.h"

namespace plumb::reports {

/// The page of a study: each figure with its text, and controls to look at it otherwise.
std::string study_html(const StudyResult& study);

/// Run, confidence level and headlines, as docs/json.md says.
std::string headlines_json(const StudyResult& study);

}  // namespace plumb::reports
