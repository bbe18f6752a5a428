#pragma once

#include <cstdint>
#include <string>

#include "reports/run/store.h"
#include "studies/reproduction.h"

namespace plumb::cli {

/// Where a reproduction goes; no folder is written for an empty name.
struct FigureOutputs {
    std::string out = "out/reproduce", store = "out/results.db";
};

/// Throws Error for a folder that holds anything else than such a page: before the work.
void check_outputs(const FigureOutputs& outputs);

/// Writes the page of this run, prints the headlines and returns the program's exit code: 0, whatever is met.
int publish(const std::vector<FigureTask>& tasks, const reports::Results& results, std::int64_t run,
            const FigureOutputs& outputs);

}  // namespace plumb::cli
