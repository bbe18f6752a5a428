#pragma once

#include <cstdint>
#include <vector>

#include "studies/own/answer.h"
#include "studies/own/user_integrand.h"

namespace plumb::own {

/// The integrals of a task, one of each integrand that it names, computed on the threads that for_batches may use.
/// Throws Error.
std::vector<Answer> integrate(const IntegralTask& task, std::uint64_t seed);

}  // namespace plumb::own
