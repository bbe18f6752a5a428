#pragma once

#include "integrators/paths/next_event/light_choice.h"

namespace plumb {

/// In proportion to what the middle of each light would send to the vertex, were nothing between; a tenth goes to all
/// alike, so that none is left out.
std::shared_ptr<const LightChoice> probed_choice();

}  // namespace plumb
