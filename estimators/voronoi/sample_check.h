#pragma once

#include <span>

#include "core/point.h"

namespace plumb {

/// Throws Error unless there is at least one sample and every coordinate lies in [0,1]; the message names the first
/// offending sample by its index.
template <int D>
void check_samples(std::span<const Point<D>> samples);

}  // namespace plumb
