#pragma once

#include <cstdint>

#include "cli/options.h"
#include "reports/run/results.h"

namespace plumb::cli {

/// Throws Error for a file that cannot be written or is asked for twice: before the work starts.
void check_outputs(const Outputs& outputs);

/// Writes the files that were asked for, prints the verdicts and returns the program's exit code.
int publish(const reports::Results& results, std::int64_t run, const Outputs& outputs);

}  // namespace plumb::cli
