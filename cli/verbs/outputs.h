#pragma once

#include <cstdint>
#include <string>

#include "reports/run/results.h"

namespace CLI {
class App;
}

namespace plumb::cli {

/// The files that verdicts go to: an empty name writes no such file.
struct Outputs {
    std::string json, junit, report = "out/report.html", store = "out/results.db";
};

void add_outputs(CLI::App& verb, Outputs& outputs);

/// Throws Error for a file that cannot be written or is asked for twice: before the work starts.
void check_outputs(const Outputs& outputs);

/// Writes the files that were asked for, prints the verdicts and returns the program's exit code.
int publish(const reports::Results& results, std::int64_t run, const Outputs& outputs);

}  // namespace plumb::cli
