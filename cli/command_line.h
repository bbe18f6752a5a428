#pragma once

#include <functional>
#include <vector>

#include "cli/verb.h"

namespace plumb::cli {

/// Reads the command line and does what its verb says; returns the program's exit code. Help, and one line with the
/// nearest known name for what cannot be read, are printed here. Throws Error.
int run_verb(int argc, const char* const* argv, const std::vector<Verb>& verbs, const Catalogue& catalogue);

/// The body of main(): an exception, or standard output that cannot be written, becomes one line on standard error,
/// after the program's name, and exit code 2.
int reporting_errors(const char* const* argv, const std::function<int()>& body);

}  // namespace plumb::cli
