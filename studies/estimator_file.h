#pragma once

#include <string>

#include "studies/section.h"
#include "studies/study.h"

namespace plumb {

/// Adds one [[estimator]] of a file to the study. Throws Error naming file, line, key, what was found and what is
/// accepted.
void read_estimator(Study& study, const toml::table& table, const std::string& file);

}  // namespace plumb
