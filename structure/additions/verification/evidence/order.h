#pragma once

#include <span>

#include "verification/verdict.h"

namespace plumb {

/// Holds when no value is below the one before it; needs no randomness. NaN refutes.
Verdict never_falls(std::span<const double> values);

}  // namespace plumb
