#pragma once

#include "cli/answer.h"

namespace plumb::cli {

/// The integral from the samples in the files options.what: several files are independent sets, one file may be cut
/// into options.batches sets. Throws Error.
Answer integrate_samples(const IntegrateOptions& options);

}  // namespace plumb::cli
