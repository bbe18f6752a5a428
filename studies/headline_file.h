#pragma once

#include <string>

#include "studies/section.h"
#include "studies/study.h"

namespace plumb {

/// One [[headline]] of a file whose figures have been read. Throws Error naming file, line, key, what was found and
/// what is accepted.
HeadlinePlan read_headline(const Study& study, const toml::table& table, const std::string& file);

}  // namespace plumb
