#pragma once

#include "cli/answer.h"
#include "cli/user_integrand.h"

namespace plumb::cli {

/// The integral from the samples in the files task.what: several files are independent sets, one file may be cut
/// into task.batches sets. Throws Error.
Answer integrate_samples(const IntegralTask& task);

}  // namespace plumb::cli
