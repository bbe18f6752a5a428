#pragma once

#include <string>
#include <string_view>

#include "studies/study.h"

namespace plumb {

/// A study from the text of its TOML file (docs/studies.md). Every name in it is looked up here, before anything is
/// drawn; throws Error in one line: file, line, key, what was found, what is accepted.
Study parse_study(std::string_view text, const std::string& file);

}  // namespace plumb
