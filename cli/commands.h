#pragma once

#include "cli/options.h"

namespace plumb {

/// The verbs: each does its work, prints to standard output and returns the program's exit code. Throws Error.
int verify(const VerifyOptions& options);
int list(const ListOptions& options);
int converge(const ConvergeOptions& options);
int integrate(const IntegrateOptions& options);
int weights(const WeightsOptions& options);
int report(const ReportOptions& options);
int merge(const MergeOptions& options);

}  // namespace plumb
