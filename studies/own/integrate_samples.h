#pragma once

#include "studies/own/answer.h"
#include "studies/own/user_integrand.h"

namespace plumb::own {

/// The integral from the samples in the files task.what: several files are independent sets, one file may be cut
/// into task.batches sets. Throws Error.
Answer integrate_samples(const IntegralTask& task);

}  // namespace plumb::own
